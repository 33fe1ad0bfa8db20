import { expect, test, vi } from "vitest";
import type { Lab } from "../lab";
import type { Session } from "./session.svelte";
import { Workspace } from "./workspace.svelte";

vi.stubGlobal("localStorage", { getItem: () => null, setItem: () => undefined });

test("an estimator stands out in its own lab alone", () => {
  const [track, localize] = [{}, {}] as Lab[];
  const session = { lab: track };
  const workspace = new Workspace(session as unknown as Session, "light");
  workspace.emphasize("kf");
  expect(workspace.emphasis).toBe("kf");
  session.lab = localize;
  expect(workspace.emphasis).toBeNull();
  workspace.emphasize("ouc-ls");
  session.lab = track;
  expect(workspace.emphasis).toBeNull();
  workspace.emphasize("kf");
  workspace.emphasize("kf");
  expect(workspace.emphasis).toBeNull();
});
