import { expect, type Locator, type Page, test } from "@playwright/test";
import { Health } from "./health";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

async function openExplore(page: Page, backend: string): Promise<Lab> {
  const lab = await Lab.open(page, `./?renderer=${backend}&theme=light`);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await expect(lab.scene).toHaveAttribute("data-backend", backend);
  return lab;
}

/** The renderer says on its canvas that it draws what the device computed. */
const fine = (page: Page): Locator => page.locator(".host canvas[data-fine-field]");

test("WebGPU draws a finer field, and another one once an anchor has moved", async ({ page }) => {
  test.setTimeout(180_000);
  const warnings: string[] = [];
  page.on("console", (message) => message.type() === "warning" && warnings.push(message.text()));
  const health = new Health(page);
  const lab = await openExplore(page, "webgpu");
  await expect(fine(page)).toHaveCount(1, { timeout: 60_000 });
  const picture = await lab.surface.screenshot();
  await lab.drag(2, -60, 40);
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await expect(fine(page)).toHaveCount(1, { timeout: 60_000 });
  expect((await lab.surface.screenshot()).equals(picture)).toBe(false);
  expect(warnings.filter((text) => text.includes("field"))).toEqual([]);
  await health.expectGood(lab);
});

test("WebGL2 and the plain canvas keep to the coarse field", async ({ page }) => {
  test.setTimeout(180_000);
  const health = new Health(page);
  for (const backend of ["webgl", "canvas2d"]) {
    const lab = await openExplore(page, backend);
    await lab.drag(2, -60, 40);
    await expect(lab.status).toContainText("Anchor 2 moved to");
    await expect(fine(page)).toHaveCount(0);
    await health.expectGood(lab);
  }
});
