import { expect, test } from "vitest";
import type { Lab } from "../lab";
import { LabLoader } from "./lab-loader.svelte";

/** A lab that comes, or not, when it is told to. */
function late() {
  let come!: () => void;
  let fail!: (error: Error) => void;
  const promise = new Promise<void>((resolve, reject) => ([come, fail] = [resolve, reject]));
  const lab = { title: "Late", load: () => promise } as unknown as Lab;
  return { lab, come, fail: () => fail(new Error("No network.")) };
}

const there = { title: "There" } as Lab;
const settled = () => new Promise((resolve) => setTimeout(resolve));

/** Everything that the loader told, in order. */
function listen() {
  const told: string[] = [];
  const ask = (loader: LabLoader, lab: Lab, name = lab.title) =>
    loader.whenThere(
      lab,
      () => told.push(name),
      (error) => told.push(`${name}: ${String(error)}`),
    );
  return { told, ask };
}

test("a lab that needs nothing is there at once", () => {
  const { told, ask } = listen();
  const loader = new LabLoader();
  ask(loader, there);
  expect([told, loader.loading]).toEqual([["There"], null]);
});

test("another lab is told when it has come, and is there at once from then on", async () => {
  const { told, ask } = listen();
  const loader = new LabLoader();
  const { lab, come } = late();
  ask(loader, lab);
  expect([told, loader.loading, loader.has(lab)]).toEqual([[], lab, false]);
  come();
  await settled();
  expect([told, loader.loading, loader.has(lab)]).toEqual([["Late"], null, true]);
  ask(loader, lab, "again");
  expect(told).toEqual(["Late", "again"]);
});

test("what is asked for next comes instead", async () => {
  const { told, ask } = listen();
  const loader = new LabLoader();
  const { lab, come } = late();
  ask(loader, lab, "first");
  ask(loader, lab, "second");
  ask(loader, there);
  expect([told, loader.loading]).toEqual([["There"], null]);
  come();
  await settled();
  expect(told).toEqual(["There"]);
});

test("a lab that does not come is told with the reason", async () => {
  const { told, ask } = listen();
  const loader = new LabLoader();
  const { lab, fail } = late();
  ask(loader, lab);
  fail();
  await settled();
  expect([told, loader.loading, loader.has(lab)]).toEqual([["Late: Error: No network."], null, false]);
});
