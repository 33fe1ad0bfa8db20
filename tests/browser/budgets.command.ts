import { expect, test } from "@playwright/test";
import { atMost, quantile, report } from "./budgets/budget";
import { Host } from "./budgets/host";
import { scores } from "./budgets/lighthouse";
import { dragTimes, frameTimes, memoryInUse, readFirsts, watchFirsts, watchMemories } from "./budgets/probes";
import { Lab } from "./lab";

const minutes = Number(process.env["MINUTES"] ?? 10);

test("first picture and first estimate, nothing cached", async ({ page }, info) => {
  const host = await Host.start("gzip");
  await watchFirsts(page);
  await Lab.open(page, `${host.address}?theme=light`);
  const firsts = await readFirsts(page);
  host.stop();
  atMost(info, "first picture", firsts.picture, 1500, "ms", false);
  atMost(info, "first estimate", firsts.estimate, 1500, "ms", false);
  atMost(info, "graphics device draws", firsts.renderer, 3000, "ms", false);
});

for (const renderer of ["canvas2d", "webgpu"])
  test(`drag to picture and play on ${renderer}`, async ({ page }, info) => {
    test.setTimeout(300_000);
    const lab = await Lab.open(page, `./?renderer=${renderer}&theme=light`);
    await lab.enableAllEstimators();
    const drags = await dragTimes(lab, 200);
    expect(drags.length).toBeGreaterThan(50);
    atMost(info, `drag to picture, p50, ${renderer}`, quantile(drags, 0.5), 16, "ms", false);
    atMost(info, `drag to picture, p95, ${renderer}`, quantile(drags, 0.95), 16, "ms", false);
    await lab.play("50 steps/s", 1000);
    const frames = await frameTimes(page, 10_000);
    atMost(info, `frame while playing, p50, ${renderer}`, quantile(frames, 0.5), 17, "ms", false);
    atMost(info, `frame while playing, p95, ${renderer}`, quantile(frames, 0.95), 34, "ms", false);
  });

test(`memory over ${minutes} minutes of play`, async ({ page }, info) => {
  test.setTimeout((minutes + 5) * 60_000);
  await watchMemories(page);
  const lab = await Lab.open(page, "./?theme=light");
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
  atMost(info, `growth of the heap, ${minutes} minutes of play`, growth("heap"), 5, "%", false);
  atMost(info, `growth of WebAssembly's memory, ${minutes} minutes`, growth("modules"), 0, "%", true);
});

for (const form of ["desktop", "mobile"] as const)
  test(`Lighthouse, ${form}`, async ({}, info) => {
    test.setTimeout(300_000);
    const host = await Host.start("gzip");
    for (const { category, score, complaints } of await scores(host.address, form)) {
      if (complaints.length) console.log(`${category}: ${complaints.join("; ")}`);
      report(info, {
        name: `Lighthouse ${category}, ${form}`,
        measured: String(score),
        limit: "at least 95",
        kept: score >= 95,
        decides: category !== "Performance",
      });
    }
    host.stop();
  });
