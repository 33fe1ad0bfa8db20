import { expect, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { report } from "./budgets/budget";
import { Lab } from "./lab";
import { enter, SIZES, STATES, THEMES } from "./states";

test("axe finds nothing in any state, theme and size", async ({ browser }, info) => {
  test.setTimeout(3_600_000);
  const found: string[] = [];
  let looked = 0;
  for (const state of STATES)
    for (const size of SIZES) {
      const context = await browser.newContext({ viewport: size });
      const page = await context.newPage();
      await enter(await Lab.open(page), state);
      for (const theme of THEMES) {
        await wear(page, theme);
        const here = `${state.name}, ${theme}, ${size.width} x ${size.height}`;
        // Of what axe looks at, a theme changes nothing but colours.
        const rules = theme === THEMES[0] ? "all" : "colours";
        found.push(...(await violations(page, rules)).map((violation) => `${here}: ${violation}`));
        looked += 1;
      }
      await context.close();
    }
  for (const line of found) console.log(line);
  expect(looked).toBe(STATES.length * SIZES.length * THEMES.length);
  report(info, {
    name: "axe violations",
    measured: `${found.length} in ${looked} states x themes x sizes`,
    limit: "0",
    kept: found.length === 0,
    decides: true,
  });
});
