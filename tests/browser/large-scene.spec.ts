import { expect, test } from "@playwright/test";
import { Lab } from "./lab";
import { goodLink, openChanged } from "./scenario-link";

/** Points of a sunflower, so that no two and no row of them are alike. */
function sunflower(count: number, radius: number, height: (index: number) => number): number[][] {
  return Array.from({ length: count }, (_, index) => {
    const [angle, r] = [2.4 * index, radius * Math.sqrt((index + 0.5) / count)];
    return [r * Math.cos(angle), r * Math.sin(angle), height(index)].map((x) => Number(x.toFixed(3)));
  });
}

test("200 anchors and 50 sensors can be explored and dragged", async ({ page }) => {
  const lab = await Lab.open(page);
  const link = await goodLink(lab);
  await openChanged(lab, link, (draft) => {
    draft.anchors = sunflower(200, 8, (index) => (index * 0.37) % 3);
    draft.sensors = sunflower(50, 0.5, (index) => ((index * 0.11) % 0.6) - 0.3);
    draft["view"] = { lab: "explore" };
  });
  const typed = page.getByRole("table", { name: "Bounds of one epoch" }).locator('[data-at="body"] td');
  await expect(typed).toHaveCount(2);
  await expect.poll(() => page.locator("#scene-twin li").count()).toBeGreaterThanOrEqual(200);
  const before = await typed.allInnerTexts();
  for (const number of before) expect(Number(number)).toBeGreaterThan(0);
  const from = await lab.anchorPixel(7);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const start = Date.now();
  for (let step = 1; step <= 20; step++) {
    await page.mouse.move(from.x - 4 * step, from.y + step);
    await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(drawn)));
  }
  const milliseconds = (Date.now() - start) / 20;
  await page.mouse.up();
  await expect(lab.status).toContainText("Anchor 7 moved to");
  // A picture a second would be no dragging any more, whatever the machine.
  expect(milliseconds).toBeLessThan(500);
  test.info().annotations.push({ type: "drag step", description: `${milliseconds.toFixed(0)} ms` });
  await expect.poll(() => typed.allInnerTexts()).not.toEqual(before);
  await page.keyboard.press("Control+z");
  await expect.poll(() => typed.allInnerTexts()).toEqual(before);
});
