import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

const quantile = (values: number[], share: number) =>
  [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))];

test("a drag shows its effect within a few frames", async ({ page }) => {
  test.setTimeout(180_000);
  const lab = await Lab.open(page);
  await page.getByRole("checkbox", { name: "ESKF raw" }).check();
  await page.evaluate(() => {
    const seen: number[] = [];
    Object.assign(window, { seen });
    new PerformanceObserver((list) => seen.push(...list.getEntries().map((entry) => entry.duration))).observe(
      {
        entryTypes: ["measure"],
      },
    );
  });
  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 0; i < 40; i++)
    await page.mouse.move(from.x + 50 * Math.sin(i / 9), from.y + 30 * Math.cos(i / 7));
  await page.mouse.up();
  const seen = await page.evaluate(() => (window as unknown as { seen: number[] }).seen);
  const [p50, p95] = [quantile(seen, 0.5), quantile(seen, 0.95)];
  console.log(
    `drag to picture over ${seen.length} frames: p50 ${p50.toFixed(1)} ms, p95 ${p95.toFixed(1)} ms`,
  );
  expect(seen.length).toBeGreaterThan(20);
  // Software rendering on a shared machine: this catches a computation that blocks, not a slow machine.
  expect(p50).toBeLessThan(1000);
});
