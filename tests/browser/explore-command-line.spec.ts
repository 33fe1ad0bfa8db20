import { execFileSync } from "node:child_process";
import { resolve } from "node:path";
import { expect, type Page, test } from "@playwright/test";
import { Lab } from "./lab";

const ROOT = resolve(import.meta.dirname, "../..");

async function savedScenario(page: Page): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Scenario as a file (JSON)" }).click();
  return (await download).path();
}

/** The bounds at a point by the command line: degrees, metres. */
function commandLine(scenario: string, point: readonly number[]): number[] {
  const options = ["field", scenario, `--at=${point.join(",")}`, "--format", "json"];
  const text = execFileSync("cargo", ["run", "--quiet", "--bin", "rangelab", "--", ...options], {
    cwd: ROOT,
    encoding: "utf8",
  });
  const { orientation_bound_deg, position_bound_m } = JSON.parse(text);
  return [orientation_bound_deg, position_bound_m];
}

test("after a drag the read-out on the field is the number of the command line", async ({ page }) => {
  test.setTimeout(600_000);
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  const typed = page.getByRole("table", { name: "Bounds of one epoch" }).locator('[data-at="typed"] td');
  const point = [2.5, 3, 1.5];
  for (const [axis, value] of point.entries()) await lab.type(`Read at, ${"xyz"[axis]}`, String(value));
  const before = (await typed.allInnerTexts()).map(Number);
  const { x, y } = await lab.anchorPixel(2);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 120, y + 60, { steps: 6 });
  await page.mouse.up();
  await expect(lab.status).toContainText("Anchor 2 moved to");
  const expected = commandLine(await savedScenario(page), point);
  const shown = (await typed.allInnerTexts()).map(Number);
  for (const [index, number] of shown.entries()) {
    // Shown to three digits.
    expect(Math.abs(number / expected[index] - 1)).toBeLessThan(0.005);
    expect(Math.abs(number / before[index] - 1)).toBeGreaterThan(0.005);
  }
});
