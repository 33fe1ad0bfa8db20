import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "@playwright/test";
import { Lab } from "./lab";
import { graphicsBrowser, plainBrowser } from "./playwright.config";
import { enter, SIZES, STATES, THEMES } from "./states";

const folder = process.env["PICTURES"] ?? fileURLToPath(new URL("pictures", import.meta.url));
const renderer = process.env["RENDERER"] ?? "canvas2d";

test.use({ launchOptions: renderer === "canvas2d" ? plainBrowser : graphicsBrowser });
test.beforeAll(() => mkdirSync(folder, { recursive: true }));

for (const state of STATES)
  for (const theme of THEMES)
    for (const size of SIZES)
      test(`${state.name}, ${theme}, ${size.width}`, async ({ page }) => {
        await page.setViewportSize(size);
        const lab = await Lab.open(page, `./?renderer=${renderer}&theme=${theme}`);
        await enter(lab, state);
        await lab.settled();
        const name = [state.name.replaceAll(" ", "-"), theme, size.width].join("_");
        await page.screenshot({ path: `${folder}/${name}.png` });
      });
