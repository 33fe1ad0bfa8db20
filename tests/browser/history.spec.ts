import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

test("undo and redo walk through every kind of edit; a drag is one", async ({ page }) => {
  const lab = await Lab.open(page);
  const states = [await lab.readout()];
  const record = async (what: RegExp) => {
    await expect(lab.status).toContainText(what);
    states.push(await lab.readout());
  };
  await lab.drag(2, 60, -30);
  await record(/Anchor 2 moved/);
  await lab.type("Noise level σ", "0.2");
  await record(/Noise level/);
  await page.getByRole("checkbox", { name: "KF-ortho" }).uncheck();
  await record(/KF-ortho switched off/);
  await page.getByRole("button", { name: "Add an anchor" }).click();
  await record(/Anchor added/);
  expect(new Set(states).size).toBe(states.length);

  for (const state of states.slice(0, -1).reverse()) {
    await page.getByRole("button", { name: "Undo" }).click();
    await expect(lab.status).toContainText("Undone");
    await expect.poll(() => lab.readout()).toBe(state);
  }
  await expect(page.getByRole("button", { name: "Undo" })).toBeDisabled();
  for (const state of states.slice(1)) {
    await page.getByRole("button", { name: "Redo" }).click();
    await expect.poll(() => lab.readout()).toBe(state);
  }
  await expect(page.getByRole("button", { name: "Redo" })).toBeDisabled();
});
