import { execFileSync } from "node:child_process";
import { resolve } from "node:path";
import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe";
import { Lab } from "./lab";

const ROOT = resolve(import.meta.dirname, "../..");

async function openNextAnchor(page: Page): Promise<Lab> {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await page.getByRole("combobox", { name: "Shows" }).selectOption("best next anchor");
  await expect(page.getByRole("table", { name: "One more anchor" })).toBeVisible();
  return lab;
}

const cell = (page: Page, row: string) =>
  page.getByRole("table", { name: "One more anchor" }).locator(`[data-at="${row}"] td`);
const number = async (page: Page, row: string) => Number(await cell(page, row).innerText());

async function savedScenario(page: Page): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Scenario as a file (JSON)" }).click();
  return (await download).path();
}

/** What the command line says of one more anchor at a point: without it and with it. */
function commandLine(scenario: string, point: readonly number[]): number[] {
  const options = ["field", scenario, `--at=${point.join(",")}`, "--format", "json"];
  const text = execFileSync("cargo", ["run", "--quiet", "--bin", "rangelab", "--", ...options], {
    cwd: ROOT,
    encoding: "utf8",
  });
  const { bound_now, bound_with_one_more_anchor } = JSON.parse(text);
  return [bound_now, bound_with_one_more_anchor];
}

test("after a drag the read-out of one more anchor is the number of the command line", async ({ page }) => {
  test.setTimeout(600_000);
  const lab = await openNextAnchor(page);
  const point = [2.5, 3, 1.5];
  for (const [axis, value] of point.entries()) await lab.type(`Read at, ${"xyz"[axis]}`, String(value));
  const before = await number(page, "typed");
  await lab.drag(2, -330, 150);
  await expect(lab.status).toContainText("Anchor 2 moved to");
  const expected = commandLine(await savedScenario(page), point);
  const shown = [await number(page, "now"), await number(page, "typed")];
  for (const [index, value] of shown.entries())
    // Shown to three digits, and the first is a 5 or more.
    expect(Math.abs(value / expected[index] - 1)).toBeLessThan(0.001);
  expect(shown[1]).toBeLessThan(shown[0]);
  expect(Math.abs(before / expected[1] - 1)).toBeGreaterThan(0.01);
});

test("Add it puts an anchor at the best place, which lowers the figure; one undo takes it away", async ({
  page,
}) => {
  const lab = await openNextAnchor(page);
  await expect(cell(page, "best")).not.toHaveText("–");
  const [now, best] = [await number(page, "now"), await number(page, "best")];
  expect(best).toBeLessThan(now);
  await expect(page.locator('svg.labels text[data-id="next anchor"]')).toContainText("7.14 mm now, ");
  const anchors = page.locator("#scene-twin li");
  const count = await anchors.count();
  await page.getByRole("button", { name: "Add it" }).click();
  await expect(lab.status).toContainText(`Anchor ${count + 1} added at (`);
  await expect(anchors).toHaveCount(count + 1);
  await expect.poll(() => number(page, "now")).toBe(best);
  await page.keyboard.press("Control+z");
  await expect(anchors).toHaveCount(count);
  await expect.poll(() => number(page, "now")).toBe(now);
  expect(await violations(page)).toEqual([]);
});

test("where no anchor may stand the read-out says why, and the target's unit is shown", async ({ page }) => {
  const lab = await openNextAnchor(page);
  const group = await lab.openGroup("Placement");
  await group.getByRole("button", { name: "Keep-out box" }).click();
  const [low, high] = [1, 2];
  for (const axis of "xyz") {
    await lab.type(`Keep out 1, low, ${axis}`, String(low));
    await lab.type(`Keep out 1, high, ${axis}`, String(high));
    await lab.type(`Read at, ${axis}`, "1.5");
  }
  await expect(cell(page, "typed")).toHaveText("–");
  await expect(page.getByText("No anchor may stand inside keep-out zone 1.")).toBeVisible();
  await group.getByRole("combobox", { name: "Bound of the" }).selectOption("orientation");
  const table = page.getByRole("table", { name: "One more anchor" });
  await expect(table.locator("thead")).toContainText("in deg");
  const legend = page.getByRole("img", { name: "Bound of the orientation, one more anchor here" });
  await expect(legend).toContainText("(deg)");
});
