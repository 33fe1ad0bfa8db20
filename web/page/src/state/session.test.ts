import { beforeEach, expect, test, vi } from "vitest";
import type { Family, SceneDocument } from "../family";
import type { Lab, LabRun } from "../lab";
import type { Scenario } from "../scenario";
import { Session } from "./session.svelte";

/** An engine that takes seeds below 100 and breaks over those in `deadly`; the next call finds it started again. */
const fake = vi.hoisted(() => ({ deadly: new Set<number>(), broken: false, restarts: 0, once: false }));

vi.mock("../engine", () => {
  class EngineTrap extends Error {}
  return {
    EngineTrap,
    validate: ({ seed }: Scenario) => (seed < 100 ? [] : [{ message: `seed is ${seed}` }]),
    complete: (document: Scenario) => document,
    track: ({ seed }: Scenario) => {
      if (fake.broken) fake.restarts += 1;
      fake.broken = fake.deadly.has(seed);
      if (fake.once) fake.deadly.delete(seed);
      if (fake.broken) throw new EngineTrap("trapped");
      return { steps: 1, seed };
    },
  };
});

const frames: FrameRequestCallback[] = [];
const reported: unknown[] = [];

vi.stubGlobal("requestAnimationFrame", (callback: FrameRequestCallback) => frames.push(callback));
vi.stubGlobal("reportError", (error: unknown) => reported.push(error));
vi.stubGlobal("history", { replaceState: () => undefined });

const scenario = (seed: number) =>
  ({ name: "a", seed, anchors: [], sensors: [], view: null }) as unknown as Scenario;

async function familyOf(name: string): Promise<Family> {
  const { complete, validate } = await import("../engine");
  const room = () => ({ dimension: 3, anchors: [], movable: true, start: [0, 0, 0], body: [] });
  return { name, validate, complete, room, claims: () => true } as unknown as Family;
}

async function labs(): Promise<Lab[]> {
  const { track } = await import("../engine");
  return [
    {
      name: "one",
      title: "One",
      family: await familyOf("body"),
      firstPreset: "first",
      presets: () => [{ name: "first", title: "First", summary: "" }],
      preset: () => scenario(0),
      compute: track,
      describe: () => "It ran.",
    } as unknown as Lab,
  ];
}

async function settle(): Promise<void> {
  for (let i = 0; i < 8; i++) {
    for (const callback of frames.splice(0)) callback(0);
    await Promise.resolve();
    await Promise.resolve();
  }
}

async function open(seed = 1): Promise<Session> {
  const session = new Session(scenario(seed), await labs());
  await settle();
  return session;
}

const seedOf = (session: Session) => (session.run as unknown as { seed: number } | null)?.seed;

beforeEach(async () => {
  // The loop of frames outlives a test: nothing may be left in it.
  await settle();
  reported.length = 0;
  fake.deadly.clear();
  [fake.broken, fake.restarts, fake.once] = [false, 0, false];
});

test("an edit is computed, named and undone", async () => {
  const session = await open();
  session.edit("Seed set to 2", scenario(2));
  await settle();
  expect([seedOf(session), session.undoes]).toEqual([2, "Seed set to 2"]);
  expect(session.announcement).toBe("Seed set to 2.");
  session.undo();
  await settle();
  expect([seedOf(session), session.undoes, session.redoes]).toEqual([1, null, "Seed set to 2"]);
});

test("a refused edit leaves everything and says why", async () => {
  const session = await open();
  expect(session.edit("Seed set to 100", scenario(100))).toBe(false);
  await settle();
  expect([seedOf(session), session.undoes]).toEqual([1, null]);
  expect(session.refusal).toContain("seed is 100");
});

test("a file that comes during a drag waits for its end", async () => {
  const session = await open();
  const file = new File([JSON.stringify(scenario(50))], "fifty.json");
  session.preview("Dragged", scenario(3));
  await session.openFile(file);
  session.preview("Dragged", scenario(4));
  expect(session.scenario.seed).toBe(4);
  session.commit();
  expect([session.scenario.seed, session.undoes]).toEqual([50, "Scenario opened from the file fifty.json"]);
  session.undo();
  expect([session.scenario.seed, session.undoes]).toEqual([4, "Dragged"]);
});

test("undo in the middle of a drag takes the drag back, a bad one and nothing else", async () => {
  const session = await open();
  session.edit("Seed set to 2", scenario(2));
  session.preview("Dragged", scenario(3));
  session.undo();
  expect([session.scenario.seed, session.redoes]).toEqual([2, "Dragged"]);
  session.preview("Dragged badly", scenario(100));
  session.undo();
  expect([session.scenario.seed, session.undoes, session.redoes]).toEqual([2, "Seed set to 2", "Dragged"]);
  session.preview("Dragged badly", scenario(100));
  session.redo();
  expect([session.scenario.seed, session.undoes]).toEqual([2, "Seed set to 2"]);
  expect(session.refusal).toContain("seed is 100");
  await settle();
});

test("the run is known to be of the scenario, or of an earlier one", async () => {
  const session = await open();
  expect(session.computed).toBe(session.scenario);
  session.preview("Dragged", scenario(3));
  expect([session.computed?.seed, seedOf(session)]).toEqual([1, 1]);
  await settle();
  expect([session.computed, seedOf(session)]).toEqual([session.scenario, 3]);
});

test("a document from elsewhere on the page opens as one edit, a bad one is refused by its name", async () => {
  const session = await open();
  await session.openDocument(scenario(9), "figure two");
  expect([session.scenario.seed, session.undoes]).toEqual([9, "Scenario opened from figure two"]);
  await session.openDocument(scenario(100), "figure two");
  expect(session.scenario.seed).toBe(9);
  expect(session.refusal).toMatch(/^Figure two holds a scenario that does not work: seed is 100/);
});

test("an engine that broke once is started again and computes the same scenario", async () => {
  const session = await open();
  fake.deadly.add(5);
  fake.once = true;
  session.edit("Seed set to 5", scenario(5));
  await settle();
  expect([seedOf(session), session.scenario.seed, fake.restarts]).toEqual([5, 5, 1]);
  expect(reported).toHaveLength(1);
  expect(session.undoes).toBe("Seed set to 5");
});

test("an engine that breaks over a scenario again goes back to the last good one", async () => {
  const session = await open();
  session.edit("Seed set to 2", scenario(2));
  await settle();
  fake.deadly.add(5);
  session.edit("Seed set to 5", scenario(5));
  await settle();
  expect([seedOf(session), session.scenario.seed, session.undoes]).toEqual([2, 2, "Seed set to 2"]);
  expect(session.refusal).toContain("last good one");
  expect(session.failure).toBeNull();
});

test("a first scene that breaks the engine gives way to the preset, and a hopeless engine is told", async () => {
  fake.deadly.add(5);
  const session = await open(5);
  expect([seedOf(session), session.scenario.seed]).toEqual([0, 0]);
  fake.deadly.add(0);
  const hopeless = await open(5);
  expect(hopeless.failure).toContain("Reload the page");
  expect(fake.restarts).toBeLessThan(10);
});

test("a lab of the same family takes the scene along, another one opens a scene of its own", async () => {
  const [one] = await labs();
  const leave = vi.fn();
  const cousin = { ...one, name: "cousin", leave };
  const stranger = { ...one, name: "stranger", family: await familyOf("other") };
  const session = new Session(scenario(7), [one, cousin, stranger]);
  session.openLab(cousin);
  expect([session.lab.name, session.scenario.seed]).toEqual(["cousin", 7]);
  session.edit("Seed set to 8", { ...session.scenario, seed: 8 });
  expect(leave).not.toHaveBeenCalled();
  session.openLab(stranger);
  expect([session.lab.name, session.scenario.seed]).toEqual(["stranger", 0]);
  expect(leave).toHaveBeenCalledTimes(1);
  session.openLab(cousin);
  expect([session.lab.name, session.scenario.seed]).toEqual(["cousin", 8]);
  await settle();
});

test("a detour over another family leads back to the scene, in whichever lab of its own family", async () => {
  const [one] = await labs();
  const cousin = { ...one, name: "cousin" };
  const stranger = { ...one, name: "stranger", family: await familyOf("other") };
  const session = new Session(scenario(7), [one, cousin, stranger]);
  session.openLab(cousin);
  session.edit("Seed set to 8", { ...session.scenario, seed: 8 });
  session.openLab(stranger);
  session.openLab(one);
  expect([session.lab.name, session.scenario.seed]).toEqual(["one", 8]);
  await settle();
});

/** A cousin of the first lab whose part of the engine comes, or not, when it is told to. */
async function withLateLab() {
  const [one] = await labs();
  let come!: () => void;
  let fail!: (error: Error) => void;
  const load = () => new Promise<void>((resolve, reject) => ([come, fail] = [resolve, reject]));
  const late = { ...one, name: "late", title: "Late", load };
  return { all: [one, late], late, come: () => come(), fail: () => fail(new Error("No network.")) };
}

test("a lab that has to be loaded opens with the scene as it is then", async () => {
  const { all, late, come } = await withLateLab();
  const session = new Session(scenario(1), all);
  session.openLab(late);
  expect([session.lab.name, session.loader.loading]).toEqual(["one", late]);
  session.preview("Dragged", scenario(2));
  come();
  await settle();
  expect(session.lab.name).toBe("one");
  session.commit();
  expect([session.lab.name, session.scenario.seed]).toEqual(["late", 2]);
  await settle();
  expect(seedOf(session)).toBe(2);
});

test("a lab that cannot be loaded is told; the last one stays", async () => {
  const { all, late, fail } = await withLateLab();
  const session = new Session(scenario(1), all);
  session.openLab(late);
  fail();
  await settle();
  expect([session.lab.name, session.undoes, seedOf(session)]).toEqual(["one", null, 1]);
  expect(session.refusal).toBe("The lab Late could not be loaded (No network). The lab One stays.");
});

test("a page that opens in a lab waits for it, and opens as without a link where it does not come", async () => {
  const { all, late, come, fail } = await withLateLab();
  const linked = { ...scenario(3), view: { lab: "late" } };
  const session = new Session(linked, all);
  expect([session.lab, session.ready, seedOf(session)]).toEqual([late, false, undefined]);
  come();
  await settle();
  expect([session.lab, session.ready, seedOf(session)]).toEqual([late, true, 3]);

  const stranded = new Session(linked, all);
  fail();
  await settle();
  expect([stranded.lab.name, stranded.ready, seedOf(stranded)]).toEqual(["one", true, 0]);
  expect(stranded.refusal).toContain("The default scene is shown instead");
});

test("undo into a lab that never came goes back to where it was, with all that was done there", async () => {
  const { all, late, fail } = await withLateLab();
  const session = new Session<LabRun, SceneDocument>({ ...scenario(3), view: { lab: "late" } }, all);
  session.openLab(all[0]);
  session.edit("Seed set to 4", { ...session.scenario, seed: 4 });
  session.undo();
  fail();
  await settle();
  session.undo();
  expect([session.lab, session.ready]).toEqual([late, false]);
  fail();
  await settle();
  expect([session.lab.name, session.scenario.seed, session.ready]).toEqual(["one", 3, true]);
  expect(session.redoes).toBe("Seed set to 4");
  expect(session.refusal).toBe("The lab Late could not be loaded (No network). The lab One stays.");
});
