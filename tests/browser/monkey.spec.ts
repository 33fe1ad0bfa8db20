import { expect, test } from "@playwright/test";
import { Health, nonsense } from "./health";
import { Lab } from "./lab";
import { Monkey } from "./monkey";

const seeds = (process.env["SEEDS"] ?? "1,2").split(",").map(Number);
const acts = Number(process.env["ACTS"] ?? 150);

// `SEEDS=3,4,5 ACTS=2000 npm --prefix tests/browser test -- monkey.spec.ts` walks farther.
for (const seed of seeds)
  test(`${acts} things done at random leave a live page, seed ${seed}`, async ({ page }) => {
    test.setTimeout(60_000 + 2_000 * acts);
    const health = new Health(page);
    const lab = await Lab.open(page);
    const monkey = new Monkey(lab, seed);
    for (let count = 0; count < acts; count++) {
      await monkey.act();
      const wrong = [...health.errors, ...(await nonsense(page))];
      expect(wrong, `after these ${count + 1}:\n${monkey.done.slice(-12).join("\n")}`).toEqual([]);
    }
    await page.keyboard.press("Escape");
    await page.goto("./?renderer=canvas2d&theme=light");
    await expect(lab.status).toContainText("Ready");
    await lab.openPreset("room");
    await health.expectGood(lab);
  });
