import { expect, test } from "@playwright/test";
import { quantile } from "./budgets/budget";
import { dragTimes } from "./budgets/probes";
import { Lab } from "./lab";

test("a drag shows its effect within a few frames", async ({ page }) => {
  test.setTimeout(180_000);
  const lab = await Lab.open(page);
  await lab.enableAllEstimators();
  const seen = await dragTimes(lab);
  const [p50, p95] = [quantile(seen, 0.5), quantile(seen, 0.95)];
  console.log(
    `drag to picture over ${seen.length} frames: p50 ${p50.toFixed(1)} ms, p95 ${p95.toFixed(1)} ms`,
  );
  expect(seen.length).toBeGreaterThan(20);
  // Software rendering on a shared machine: this catches a computation that blocks, not a slow machine.
  expect(p50).toBeLessThan(1000);
});
