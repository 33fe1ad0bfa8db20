import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

test("play runs from the start to the end, pause holds, reset goes back", async ({ page }) => {
  const lab = await Lab.open(page);
  const count = await lab.step.innerText();
  await page.getByLabel("Speed").selectOption("10 steps/s");
  await page.getByRole("button", { name: "Play" }).click();
  await expect.poll(async () => Number(await lab.step.innerText())).toBeGreaterThan(3);
  await page.getByRole("button", { name: "Pause" }).click();
  const held = await lab.step.innerText();
  await page.waitForTimeout(400);
  await expect(lab.step).toHaveText(held);
  await page.getByRole("button", { name: "Back to the first step" }).click();
  await expect(lab.step).toHaveText("1");
  await page.getByLabel("Speed").selectOption("50 steps/s");
  await page.getByRole("button", { name: "Play" }).click();
  await expect(lab.step).toHaveText(count);
  await expect(page.getByRole("button", { name: "Play" })).toBeVisible();
});

test("stepping back shows the very same numbers again", async ({ page }) => {
  const lab = await Lab.open(page);
  await page.getByRole("button", { name: "One step back" }).click();
  const before = await lab.readout();
  await page.getByRole("button", { name: "One step on" }).click();
  expect(await lab.readout()).not.toBe(before);
  await page.getByRole("button", { name: "One step back" }).click();
  expect(await lab.readout()).toBe(before);
});

test("scrubbing works by key on the slider and by pointer on a plot", async ({ page }) => {
  const lab = await Lab.open(page);
  const slider = page.getByRole("slider", { name: "Step", exact: true });
  await slider.focus();
  await page.keyboard.press("Home");
  await expect(lab.step).toHaveText("1");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await expect(lab.step).toHaveText("3");
  const plot = await page.locator(".plots .u-over").first().boundingBox();
  if (!plot) throw new Error("no plot");
  await page.mouse.click(plot.x + plot.width / 2, plot.y + plot.height / 2);
  const last = Number(await slider.getAttribute("max")) + 1;
  const step = Number(await lab.step.innerText());
  expect(Math.abs(step - last / 2)).toBeLessThan(0.06 * last + 1);
});

test("the space bar plays, comma and full stop step, End goes to the last step", async ({ page }) => {
  const lab = await Lab.open(page);
  const count = Number(await lab.step.innerText());
  await page.keyboard.press(",");
  await expect(lab.step).toHaveText(String(count - 1));
  await page.keyboard.press(".");
  await expect(lab.step).toHaveText(String(count));
  await page.keyboard.press("Space");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await page.keyboard.press("Space");
  await page.keyboard.press("End");
  await expect(lab.step).toHaveText(String(count));
});
