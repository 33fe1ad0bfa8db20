import { expect, type Locator, test } from "@playwright/test";
import { Lab } from "./lab";

const threshold = (lab: Lab): Locator => lab.plot("Defect").getByRole("slider", { name: "ET threshold ε" });
const valueOf = async (slider: Locator): Promise<number> =>
  Number(await slider.getAttribute("aria-valuenow"));

/** How often ET-KF projected, as the status line says. */
async function projections(lab: Lab): Promise<number> {
  return Number(/projected at (\d+) of/.exec(await lab.status.innerText())?.[1]);
}

async function centre(locator: Locator): Promise<{ x: number; y: number }> {
  const box = await locator.boundingBox();
  if (!box) throw new Error("not on the page");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("the threshold is dragged in the plot: events follow, and one undo takes it back", async ({ page }) => {
  const lab = await Lab.open(page);
  const slider = threshold(lab);
  const [value, events] = [await valueOf(slider), await projections(lab)];
  const { x, y } = await centre(slider);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 35, { steps: 7 });
  const during = await valueOf(slider);
  expect(during).toBeLessThan(0.6 * value);
  await page.mouse.up();
  await expect(lab.status).toContainText("ET threshold set to");
  await expect.poll(() => projections(lab)).toBeGreaterThan(events);
  expect(await lab.field("ET threshold ε").inputValue()).toBe(String(during));
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => valueOf(slider)).toBe(value);
  await expect.poll(() => projections(lab)).toBe(events);
  await expect(page.getByRole("button", { name: "Undo" })).toBeDisabled();
});

test("the threshold moves by key, small steps with Shift, and never past its ends", async ({ page }) => {
  const lab = await Lab.open(page);
  const slider = threshold(lab);
  const value = await valueOf(slider);
  await slider.focus();
  await page.keyboard.press("ArrowUp");
  const coarse = await valueOf(slider);
  expect(coarse).toBeGreaterThan(value);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Shift+ArrowUp");
  const fine = await valueOf(slider);
  expect(fine).toBeGreaterThan(value);
  expect(fine).toBeLessThan(coarse);
  await page.keyboard.press("Home");
  expect(await valueOf(slider)).toBe(Number(await slider.getAttribute("aria-valuemin")));
  await page.keyboard.press("End");
  expect(await valueOf(slider)).toBe(Number(await slider.getAttribute("aria-valuemax")));
  await expect(lab.status).toContainText("projected at 0 of");
  await expect(slider).toBeFocused();
});

test("a finger drags the threshold", async ({ browser }) => {
  const context = await browser.newContext({ hasTouch: true, viewport: { width: 390, height: 844 } });
  const page = await context.newPage();
  const lab = await Lab.open(page);
  const slider = threshold(lab);
  await slider.scrollIntoViewIfNeeded();
  const value = await valueOf(slider);
  const { x, y } = await centre(slider);
  const client = await context.newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", dy: number) =>
    client.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x, y: y + dy }],
    });
  await touch("touchStart", 0);
  for (const dy of [-8, -16, -24]) await touch("touchMove", dy);
  await touch("touchEnd", 0);
  await expect.poll(() => valueOf(slider)).toBeGreaterThan(1.2 * value);
  await context.close();
});

test("the pointer in one plot shows the same step in all of them, with its numbers", async ({ page }) => {
  const lab = await Lab.open(page);
  const step = await lab.step.innerText();
  const { x, y } = await centre(lab.plot("Orientation error").locator(".u-over"));
  const scene = await lab.surface.screenshot();
  await page.mouse.move(x, y);
  await expect(page.locator(".plots .pointed")).toHaveCount(await page.locator(".plots figure").count());
  const card = lab.plot("Orientation error").locator(".card");
  const pointed = Number(/step (\d+)/.exec(await card.innerText())?.[1]);
  expect(Math.abs(pointed - Number(step) / 2)).toBeLessThan(3);
  await expect(lab.step).toHaveText(step);
  // A ghost of the body stands there in the scene.
  await expect.poll(async () => (await lab.surface.screenshot()).equals(scene)).toBe(false);
  const shown = await card.locator("tr").filter({ hasText: "UC-KF" }).locator("td").innerText();
  await page.mouse.down();
  await page.mouse.up();
  await expect(lab.step).toHaveText(String(pointed));
  expect((await lab.errors("uc-kf"))[0]).toBe(shown);
  await page.mouse.move(5, 5);
  await expect(page.locator(".plots .pointed")).toHaveCount(0);
});

test("the scale is chosen plot by plot and remembered", async ({ page }) => {
  const lab = await Lab.open(page);
  const picture = () => lab.plot("Position error").locator("canvas").screenshot();
  const before = await picture();
  await page.getByRole("button", { name: "Position error: scale, table, files" }).click();
  await page.getByRole("radio", { name: "linear" }).check();
  await page.keyboard.press("Escape");
  await expect.poll(async () => (await picture()).equals(before)).toBe(false);
  await page.reload();
  await page.getByRole("button", { name: "Position error: scale, table, files" }).click();
  await expect(page.getByRole("radio", { name: "linear" })).toBeChecked();
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Orientation error: scale, table, files" }).click();
  await expect(page.getByRole("radio", { name: "log" })).toBeChecked();
});

test("a plot is enlarged to the whole width and goes back, by button and by Escape", async ({ page }) => {
  const lab = await Lab.open(page);
  const figures = page.locator(".plots figure");
  const count = await figures.count();
  const width = (await page.locator(".plots").boundingBox())?.width;
  await page.getByRole("button", { name: "Defect ‖QᵀQ − I‖: enlarge" }).click();
  await expect(figures).toHaveCount(1);
  expect((await figures.boundingBox())?.width).toBe(width);
  await figures.getByRole("button", { name: "ET-KF" }).click();
  await expect(figures.getByRole("button", { name: "ET-KF" })).toHaveAttribute("aria-pressed", "true");
  await page.keyboard.press("Escape");
  await expect(figures).toHaveCount(count);
  await expect(lab.plot("Defect")).toBeVisible();
});

test("a click on an estimator in the table of errors lets it stand out in the plots", async ({ page }) => {
  const lab = await Lab.open(page);
  const canvas = lab.plot("Orientation error").locator("canvas");
  const before = await canvas.screenshot();
  const name = page.locator('[data-estimator="uc-kf"]').getByRole("button", { name: "UC-KF" });
  await name.click();
  await expect(name).toHaveAttribute("aria-pressed", "true");
  await expect.poll(async () => (await canvas.screenshot()).equals(before)).toBe(false);
  await name.click();
  await expect.poll(async () => (await canvas.screenshot()).equals(before)).toBe(true);
});

test("one chooses which plots are shown; where room is short, the latest choice has it", async ({ page }) => {
  await Lab.open(page);
  const titles = () => page.locator(".plots figure .title").allInnerTexts();
  const chooser = page.getByRole("group", { name: "Plots shown" });
  const all = await titles();
  await chooser.getByRole("button", { name: "Position" }).click();
  expect(await titles()).toEqual(all.filter((title) => !title.startsWith("Position")));
  await chooser.getByRole("button", { name: "Position" }).click();
  expect(await titles()).toEqual(all);
  await page.setViewportSize({ width: 900, height: 768 });
  await expect.poll(titles).not.toEqual(all);
  const hidden = chooser.locator("button[aria-pressed=false]").first();
  const name = await hidden.innerText();
  await hidden.click();
  expect((await titles()).join()).toContain(name);
});
