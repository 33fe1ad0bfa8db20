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
  await record(/Anchor 7 added/);
  expect(new Set(states).size).toBe(states.length);

  await expect(page.getByRole("button", { name: "Undo" })).toHaveAttribute("title", /Anchor 7 added/);
  for (const state of states.slice(0, -1).reverse()) {
    await page.getByRole("button", { name: "Undo" }).click();
    await expect(lab.status).toContainText("Undone");
    await expect.poll(() => lab.readout()).toBe(state);
  }
  await expect(page.getByRole("button", { name: "Undo" })).toBeDisabled();
  await expect(page.getByRole("button", { name: "Redo" })).toHaveAttribute("title", /Anchor 2 moved/);
  for (const state of states.slice(1)) {
    await page.getByRole("button", { name: "Redo" }).click();
    await expect.poll(() => lab.readout()).toBe(state);
  }
  await expect(page.getByRole("button", { name: "Redo" })).toBeDisabled();
});

test("two hundred edits are undone one by one, and a reset is undone too", async ({ page }) => {
  test.setTimeout(180_000);
  const lab = await Lab.open(page);
  const [start, seed] = [await lab.readout(), lab.field("Seed")];
  await seed.focus();
  for (let i = 0; i < 200; i++) await page.keyboard.press("ArrowUp");
  const first = Number(await seed.inputValue()) - 200;
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect(seed).toHaveValue(String(first));
  await page.keyboard.press("Control+z");
  await expect(seed).toHaveValue(String(first + 200));
  for (let i = 199; i >= 0; i--) await page.keyboard.press("Control+z");
  await expect(seed).toHaveValue(String(first));
  await expect(page.getByRole("button", { name: "Undo" })).toBeDisabled();
  await expect.poll(() => lab.readout()).toBe(start);
});
