import AxeBuilder from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { Lab } from "./lab";
import { enter, SIZES, STATES, THEMES } from "./states";

const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

async function violations(page: Page, rules: "all" | "colour"): Promise<string[]> {
  const axe = new AxeBuilder({ page });
  const { violations } = await (
    rules === "all" ? axe.withTags(tags) : axe.withRules("color-contrast")
  ).analyze();
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`);
}

for (const state of STATES)
  for (const size of SIZES)
    test(`axe finds nothing: ${state.name}, ${size.width} x ${size.height}`, async ({ page }) => {
      await page.setViewportSize(size);
      await enter(await Lab.open(page), state);
      for (const theme of THEMES) {
        // Of what axe looks at, themes change nothing but colours.
        await page.evaluate((name) => (document.documentElement.dataset["theme"] = name), theme);
        expect(await violations(page, theme === "light" ? "all" : "colour"), theme).toEqual([]);
      }
    });

test("nothing jumps while numbers change", async ({ page }) => {
  const lab = await Lab.open(page);
  const layout = () =>
    page.evaluate(() =>
      [".scene", ".timeline", ".plots", "aside", ".readout"].map((part) => {
        const box = document.querySelector(part)?.getBoundingClientRect();
        return [part, box?.x, box?.y, box?.width, box?.height].join(" ");
      }),
    );
  const before = await layout();
  for (const level of ["0.0002", "0.5", "9"]) {
    await lab.type("Noise level σ", level);
    await expect(lab.status).toContainText("Noise level");
    expect(await layout()).toEqual(before);
  }
});
