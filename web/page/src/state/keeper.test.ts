import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { SceneDocument } from "../family";
import { Keeper } from "./keeper";

const addresses: string[] = [];
vi.stubGlobal("location", { pathname: "/page/", search: "?theme=light" });
vi.stubGlobal("history", {
  replaceState: (_: unknown, __: string, address: string) => addresses.push(address),
});
vi.stubGlobal("localStorage", { setItem: () => undefined });

const scene = (view: SceneDocument["view"]): SceneDocument => ({ version: 1, name: "a", seed: 1, view });

beforeEach(() => void (addresses.length = 0));
afterEach(() => void vi.useRealTimers());

test.each([
  ["its link", scene(null), /^#v1\./],
  [
    "none where it is too large for one",
    scene({ path: Array.from({ length: 3000 }, Math.random) }),
    /^\/page\/\?theme=light$/,
  ],
])("the address gets the scene's link: %s", async (_what, scenario, expected) => {
  vi.useFakeTimers();
  new Keeper().edited(scenario);
  vi.runAllTimers();
  vi.useRealTimers();
  await vi.waitFor(() => expect(addresses).toEqual([expect.stringMatching(expected)]));
});
