import { beforeAll, describe, expect, test, vi } from "vitest";
import * as engine from ".";

interface Files {
  readFileSync(file: URL): Uint8Array<ArrayBuffer>;
}

const NOWHERE = 0xfffffff0;
let traps = false;
let readTraps = false;
let instances = 0;

/** An instance whose `track` reads outside its memory while `traps` is set, and the reading of a run too: real traps. */
function trapping(exports: WebAssembly.Exports): WebAssembly.Exports {
  const track = exports.track as (...numbers: number[]) => unknown;
  const times = exports.trackrun_times as (...numbers: number[]) => unknown;
  return {
    ...exports,
    track: (...given: number[]) => (traps ? track(NOWHERE, 64, 0) : track(...given)),
    trackrun_times: (...given: number[]) => (readTraps ? track(NOWHERE, 64, 0) : times(...given)),
  };
}

beforeAll(async () => {
  const real = WebAssembly.Instance;
  class Instance extends real {
    constructor(module: WebAssembly.Module, imports?: WebAssembly.Imports) {
      super(module, imports);
      instances += 1;
      Object.defineProperty(this, "exports", { value: trapping(super.exports) });
    }
  }
  const instantiate = async (module: WebAssembly.Module, imports: WebAssembly.Imports) =>
    new Instance(module, imports);
  vi.stubGlobal("WebAssembly", Object.assign(Object.create(WebAssembly), { Instance, instantiate }));
  const { readFileSync } = await vi.importActual<Files>("node:fs");
  const file = new URL("../wasm/track/rangelab_track_bg.wasm", import.meta.url);
  await engine.trackModule.load(new WebAssembly.Module(readFileSync(file)));
});

describe("after a trap", () => {
  test("the engine says so in a sentence, and the next call finds it whole", () => {
    const room = engine.preset("room");
    const before = engine.track(room);
    const study = new engine.StudySum(room);
    traps = true;
    expect(() => engine.track(room)).toThrow(engine.EngineTrap);
    expect(() => engine.track(room)).toThrow("has to be started again");
    expect(instances).toBe(2);
    traps = false;
    expect(engine.track(room)).toEqual(before);
    expect(instances).toBe(3);
    expect(() => study.read()).toThrow(engine.EngineRestarted);
    study.free();
    expect(engine.track(room)).toEqual(before);
  });

  test("a study is lost with its instance at once, whoever calls next", () => {
    const room = engine.preset("room");
    const study = new engine.StudySum(room);
    traps = true;
    expect(() => engine.track(room)).toThrow(engine.EngineTrap);
    traps = false;
    expect(() => study.read()).toThrow(engine.EngineRestarted);
    study.free();
  });

  test("a run that breaks while it is read is a trap as well", () => {
    const before = engine.track(engine.preset("room"));
    readTraps = true;
    expect(() => engine.track(engine.preset("room"))).toThrow(engine.EngineTrap);
    readTraps = false;
    expect(engine.track(engine.preset("room"))).toEqual(before);
  });

  test("a refusal starts nothing anew: studies under way go on", () => {
    const [room, started] = [engine.preset("room"), instances];
    const study = new engine.StudySum(room);
    expect(() => engine.preset("nowhere")).toThrow("nowhere");
    study.push(engine.studyBlock(room, 0, engine.trialsPerBlock()));
    expect([study.read().trials, instances]).toEqual([engine.trialsPerBlock(), started]);
    study.free();
  });
});

test("what is missing in a document is filled in", () => {
  const room = engine.preset("room");
  const { version, dimension, anchors, sensors, noise } = room;
  const complete = engine.complete({ version, dimension, anchors, sensors, noise });
  expect(Object.keys(complete).sort()).toEqual(Object.keys(room).sort());
  expect(complete.initial.position).toEqual([0, 0, 0]);
  expect(engine.complete(room)).toEqual(room);
  expect(() => engine.complete({ version, dimension })).toThrow("anchors");
  expect(() => engine.complete(null)).toThrow("scenario");
});

test("a run carries what scene, plots and read-out show", () => {
  const room = engine.preset("room");
  const run = engine.track({ ...room, missing_probability: 0.2 });
  const [anchors, sensors] = [room.anchors.length, room.sensors.length];
  expect(run.present).toHaveLength(run.steps * anchors * sensors);
  expect(new Set(run.present)).toEqual(new Set([0, 1]));
  expect(run.geometry.unseen).toBeNull();
  for (const each of [...run.estimators, ...run.bounds])
    expect(each.rotationCovariances).toHaveLength(run.steps * 9);
  const [kf] = run.estimators;
  expect([kf.nees.length, kf.neesDegreesOfFreedom]).toEqual([run.steps, 12]);
});

test("blocks joined in order are one study", () => {
  const room = engine.preset("room");
  const study = new engine.StudySum(room);
  for (const first of [0, 20]) study.push(engine.studyBlock(room, first, engine.trialsPerBlock()));
  const whole = new engine.StudySum(room);
  whole.push(engine.studyBlock(room, 0, 40));
  expect(study.read()).toEqual(whole.read());
  expect(study.read().trials).toBe(40);
  expect(study.read().estimators.map((each) => each.name)).toEqual(room.estimators.enabled);
  expect(() => study.push(engine.studyBlock(room, 0, 20))).toThrow("0 trials before");
  study.free();
  whole.free();
});

test("the chi-square interval is the table's, and nonsense is refused with a sentence", () => {
  const [low, high] = engine.chiSquaredInterval(12, 0.95);
  expect(low).toBeCloseTo(4.4037885069817, 12);
  expect(high).toBeCloseTo(23.3366641586453, 12);
  expect(() => engine.chiSquaredInterval(12, 1)).toThrow("below 1");
});
