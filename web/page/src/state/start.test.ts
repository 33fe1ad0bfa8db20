import { beforeEach, expect, test, vi } from "vitest";
import type { Family, SceneDocument } from "../family";
import type { Lab } from "../lab";
import { AUTOSAVE } from "./keeper";
import { encodeLink } from "./link";
import { startSession } from "./start";

vi.mock("../engine", () => ({ EngineTrap: class extends Error {} }));
vi.stubGlobal("requestAnimationFrame", () => 0);
vi.stubGlobal("history", { replaceState: () => undefined });

const stored = new Map<string, string>();
vi.stubGlobal("localStorage", {
  getItem: (key: string) => stored.get(key) ?? null,
  setItem: (key: string, value: string) => stored.set(key, value),
  removeItem: (key: string) => stored.delete(key),
});
const kept = () => stored.get(`rangelab.${AUTOSAVE}`);
const keep = (text: string) => stored.set(`rangelab.${AUTOSAVE}`, text);

const scene = (seed: number, lab: string | null = null): SceneDocument => ({
  version: 1,
  name: "a",
  seed,
  view: lab === null ? null : { lab },
});

function labOfFamily(name: string, family: Partial<Family>): Lab {
  const room = () => ({ dimension: 3, anchors: [], movable: true, start: [0, 0, 0], body: [] });
  return {
    name,
    title: name,
    firstPreset: "first",
    presets: () => [],
    preset: () => scene(0, name),
    compute: () => ({ steps: 1 }),
    family: {
      name,
      claims: () => name === "here",
      validate: () => [],
      complete: (document: unknown) => document as SceneDocument,
      room,
      ...family,
    },
  } as unknown as Lab;
}

let network = true;
let loads = 0;
const load = () => {
  loads += 1;
  return network ? Promise.resolve() : Promise.reject(new Error("No network."));
};
const labs = [labOfFamily("here", {}), labOfFamily("far", { load })];

beforeEach(() => {
  stored.clear();
  [network, loads] = [true, 0];
});

test("a kept scene whose lab does not come stays kept, is told, and comes with the next visit", async () => {
  keep(JSON.stringify(scene(7, "far")));
  network = false;
  const stranded = await startSession("", labs);
  expect([stranded.scenario.seed, stranded.restored]).toEqual([0, false]);
  expect(stranded.refusal).toBe(
    "The lab far could not be loaded (No network). The default scene is shown instead; reload the page to try again.",
  );
  expect(kept()).toBeDefined();
  network = true;
  const session = await startSession("", labs);
  expect([session.scenario.seed, session.restored, session.refusal]).toEqual([7, true, null]);
});

test("a kept scene that is none is forgotten and told", async () => {
  keep("{");
  const session = await startSession("", labs);
  expect([session.scenario.seed, kept()]).toEqual([0, undefined]);
  expect(session.refusal).toContain("no JSON document. The default scene is shown instead.");
});

test("a link neither waits for the kept scene nor touches it", async () => {
  keep(JSON.stringify(scene(7, "far")));
  const session = await startSession(await encodeLink(scene(3)), labs);
  expect([session.scenario.seed, session.refusal, loads]).toEqual([3, null, 0]);
});

test("a link that cannot be read gives way to the kept scene", async () => {
  keep(JSON.stringify(scene(7)));
  const session = await startSession("#v1.AAAA", labs);
  expect(session.scenario.seed).toBe(7);
  expect(session.refusal).toMatch(/damaged.*Your last scene is shown instead\.$/);
});
