import { expect, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Lab } from "./lab";
import { enter, SIZES, STATES, THEMES } from "./states";

// Every state once, in turn in each theme and size; `npm --prefix tests/browser run axe` takes all combinations.
for (const [index, state] of STATES.entries()) {
  const size = SIZES[index % SIZES.length];
  const theme = THEMES[Math.floor(index / SIZES.length) % THEMES.length];
  test(`axe finds nothing: ${state.name}, ${theme}, ${size.width} x ${size.height}`, async ({ page }) => {
    await page.setViewportSize(size);
    await enter(await Lab.open(page), state);
    await wear(page, theme);
    expect(await violations(page)).toEqual([]);
  });
}

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
