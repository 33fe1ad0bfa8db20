import { expect, test } from "@playwright/test";
import { Lab } from "../lab";
import { atMost, quantile } from "./budget";
import { Host } from "./host";
import { dragTimes, frameTimes, memoryInUse, readFirsts, watchFirsts, watchMemories } from "./probes";

const minutes = Number(process.env["MINUTES"] ?? 10);

/** The budgets of time and memory, with the scene drawn by that renderer. */
export function measureOn(renderer: "canvas2d" | "webgpu"): void {
  const address = `?renderer=${renderer}&theme=light`;
  const note = `, ${renderer}`;

  test(`first picture on ${renderer}, nothing cached`, async ({ page }, info) => {
    const host = await Host.start("gzip");
    await watchFirsts(page);
    const lab = await Lab.open(page, host.address + address);
    await expect(lab.scene).toHaveAttribute("data-backend", renderer);
    const firsts = await readFirsts(page);
    host.stop();
    atMost(info, `first picture${note}`, firsts.picture, 1500, "ms", false);
    atMost(info, `first estimate${note}`, firsts.estimate, 1500, "ms", false);
  });

  test(`drag and play on ${renderer}`, async ({ page }, info) => {
    test.setTimeout(300_000);
    const lab = await Lab.open(page, `./${address}`);
    await lab.enableAllEstimators();
    const drags = await dragTimes(lab, 200);
    expect(drags.length).toBeGreaterThan(50);
    atMost(info, `drag to picture, p50${note}`, quantile(drags, 0.5), 16, "ms", false);
    atMost(info, `drag to picture, p95${note}`, quantile(drags, 0.95), 16, "ms", false);
    await lab.play("50 steps/s", 1000);
    const frames = await frameTimes(page, 10_000);
    atMost(info, `frame while playing 1000 steps, p50${note}`, quantile(frames, 0.5), 17, "ms", false);
    atMost(info, `frame while playing 1000 steps, p95${note}`, quantile(frames, 0.95), 34, "ms", false);
  });

  test(`drag in Explore on ${renderer}`, async ({ page }, info) => {
    test.setTimeout(300_000);
    const lab = await Lab.open(page, `./${address}`);
    await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
    await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
    const drags = await dragTimes(lab, 200);
    expect(drags.length).toBeGreaterThan(50);
    atMost(info, `drag to picture in Explore, p50${note}`, quantile(drags, 0.5), 16, "ms", false);
    atMost(info, `drag to picture in Explore, p95${note}`, quantile(drags, 0.95), 16, "ms", false);
  });

  test(`memory over ${minutes} minutes of play on ${renderer}`, async ({ page }, info) => {
    test.setTimeout((minutes + 5) * 60_000);
    await watchMemories(page);
    const lab = await Lab.open(page, `./${address}`);
    const client = await page.context().newCDPSession(page);
    await lab.play("10 steps/s", 300);
    // What is made once, such as compiled code and caches, is no growth.
    await page.waitForTimeout(60_000);
    const start = await memoryInUse(page, client);
    for (let minute = 0; minute < minutes; minute++) {
      await page.waitForTimeout(60_000);
      await lab.keepPlaying();
    }
    const end = await memoryInUse(page, client);
    const growth = (part: "heap" | "modules") => 100 * (end[part] / start[part] - 1);
    console.log(JSON.stringify({ start, end }));
    atMost(info, `heap, growth in ${minutes} minutes of play${note}`, growth("heap"), 5, "%", false);
    atMost(info, `WebAssembly memory, the same${note}`, growth("modules"), 0, "%", true);
  });
}
