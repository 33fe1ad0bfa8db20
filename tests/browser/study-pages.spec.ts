import { expect, type Locator, type Page, test } from "@playwright/test";
import { violations } from "./axe";
import { Lab } from "./lab";

const trials = async (page: Page) => Number(await page.getByTestId("trials").innerText());
const handleIn = (lab: Lab, title: string): Locator =>
  lab.plot(title).getByRole("slider", { name: "ET threshold ε" });

async function openPage(page: Page, title: string, preset = "tracking-paper"): Promise<Lab> {
  const lab = await Lab.open(page);
  await lab.openPreset(preset);
  await page.getByRole("button", { name: title, exact: true }).click();
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThan(0);
  return lab;
}

/** The numbers of a plot, by its file. */
async function rowsOf(lab: Lab, title: string): Promise<string[][]> {
  const [download] = await Promise.all([
    lab.page.waitForEvent("download"),
    lab.plotMenu(title, "Save as CSV"),
  ]);
  const stream = await download.createReadStream();
  let text = "";
  for await (const chunk of stream) text += String(chunk);
  const lines = text.split("\r\n").filter((line) => line && !line.startsWith("#"));
  return lines.slice(1).map((line) => line.split(","));
}

async function dragBy(page: Page, slider: Locator, dx: number): Promise<void> {
  const box = (await slider.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y, { steps: 6 });
  await page.mouse.up();
}

test("the threshold is dragged along its axis: the scenario follows, one undo takes it back", async ({
  page,
}) => {
  test.setTimeout(120_000);
  const lab = await openPage(page, "ET budget");
  const slider = handleIn(lab, "Error of Q by threshold");
  await expect(slider).toHaveAttribute("aria-valuenow", "0.15");
  await expect(lab.plot("Error of Q by threshold").getByText("paper: 0.15")).toBeVisible();
  await page.getByRole("button", { name: "Stop" }).click();
  const [before, counted] = [await rowsOf(lab, "Projections in a run"), await trials(page)];
  await dragBy(page, slider, 40);
  const dragged = Number(await slider.getAttribute("aria-valuenow"));
  expect(dragged).toBeGreaterThan(0.18);
  await expect(lab.status).toContainText("ET threshold set to");
  expect(await lab.field("ET threshold ε").inputValue()).toBe(String(dragged));
  // The study is of all thresholds: none of it is lost.
  expect(await trials(page)).toBeGreaterThanOrEqual(counted);
  expect((await rowsOf(lab, "Projections in a run")).length).toBe(before.length);
  await page.keyboard.press("Control+z");
  await expect(slider).toHaveAttribute("aria-valuenow", "0.15");
  expect(await lab.field("ET threshold ε").inputValue()).toBe("0.15");
});

test("along projections the handle goes the same way as the pointer and the arrow keys", async ({ page }) => {
  const lab = await openPage(page, "ET budget");
  const slider = handleIn(lab, "Error of Q by projections");
  const place = async () => (await slider.boundingBox())!.x;
  const [before, value] = [await place(), Number(await slider.getAttribute("aria-valuenow"))];
  await dragBy(page, slider, 50);
  expect((await place()) - before).toBeGreaterThan(35);
  expect(Number(await slider.getAttribute("aria-valuenow"))).toBeLessThan(value);
  const dragged = await place();
  await slider.press("ArrowRight");
  expect(await place()).toBeGreaterThan(dragged);
  await expect(page.locator(".plots p.told")).toContainText("projections a run");
});

test("a study page tells how far it is, stops where it is told, and goes on", async ({ page }) => {
  test.setTimeout(120_000);
  await openPage(page, "ET budget");
  await page.getByRole("button", { name: "Stop" }).click();
  await page.waitForTimeout(1500);
  const held = await trials(page);
  await page.waitForTimeout(1000);
  expect(await trials(page)).toBe(held);
  await expect(page.getByRole("progressbar", { name: "Trials" })).toHaveAttribute("max", "1000");
  await page.getByRole("button", { name: "Go on" }).click();
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThan(held);
});

test("draws of anchors are points; what they are is told; other pages come and go", async ({ page }) => {
  test.setTimeout(120_000);
  const lab = await openPage(page, "Anchor draws", "tracking-paper-redrawn");
  await expect.poll(() => trials(page), { timeout: 90_000 }).toBe(500);
  await expect(page.locator(".plots p.told")).toContainText("Condition: median");
  const rows = await rowsOf(lab, "Position by anchor condition");
  const conditions = rows.map(([condition]) => Number(condition));
  expect(conditions.toSorted((one, other) => one - other)).toEqual(conditions);
  expect(rows.length).toBe(500);
  expect(await lab.readout()).not.toContain("RMSE of");
  await page.getByRole("button", { name: "One run" }).click();
  await expect(lab.plot("Orientation error")).toBeVisible();
  await expect.poll(() => page.workers().length).toBe(0);
});

test("a filter that is too sure of itself is told so beside its NIS", async ({ page }) => {
  test.setTimeout(120_000);
  const lab = await openPage(page, "Monte-Carlo", "overconfident");
  await expect.poll(() => trials(page), { timeout: 90_000 }).toBeGreaterThanOrEqual(60);
  await expect(page.locator(".plots p.told")).toContainText(/too sure of themselves: mean NEES.* NIS up to/);
  const nis = lab.plot("Mean NIS / dof");
  const chooser = page.getByRole("group", { name: "Plots shown" });
  if (!(await nis.isVisible())) await chooser.getByRole("button", { name: "NIS" }).click();
  await expect(nis).toBeVisible();
});

for (const [title, most] of [
  ["ET budget", 1000],
  ["Anchor draws", 500],
] as const)
  test(`axe finds nothing on the page ${title}`, async ({ page }) => {
    test.setTimeout(180_000);
    await openPage(page, title);
    await expect.poll(() => trials(page), { timeout: 150_000 }).toBe(most);
    expect(await violations(page)).toEqual([]);
  });
