import { readdirSync, readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { expect, test } from "@playwright/test";
import { atMost } from "./budgets/budget";
import { DIST, type Encoding, Host } from "./budgets/host";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

/**
 * The budget of 150 kB is missed and reported as missed. What every check holds is that the module does not grow by
 * accident: this is what it weighs with the field, the exploration and the placement adviser in, rounded up.
 */
const HEAVIEST_MODULE_KB = 380;

test("the estimators' module grows no further", ({}, info) => {
  const [file] = readdirSync(`${DIST}/assets`).filter((name) => /^rangelab_wasm_bg-.*\.wasm$/.test(name));
  const bytes = gzipSync(readFileSync(`${DIST}/assets/${file}`), { level: 9 }).length;
  atMost(info, "estimators' module, gzip", bytes / 1000, 150, "kB", false);
  atMost(
    info,
    "estimators' module, gzip, no heavier than it was",
    bytes / 1000,
    HEAVIEST_MODULE_KB,
    "kB",
    true,
  );
});

for (const encoding of ["gzip", "br"] as Encoding[])
  test(`what travels to a browser with WebGPU is little (${encoding})`, async ({ page }, info) => {
    test.setTimeout(180_000);
    const host = await Host.start(encoding);
    const lab = await Lab.open(page, host.address);
    await expect(lab.scene).toHaveAttribute("data-backend", "webgpu");
    await page.waitForLoadState("networkidle");
    host.stop();
    const files = [...host.sent].sort(([, a], [, b]) => b - a);
    for (const [path, bytes] of files) console.log(`${(bytes / 1000).toFixed(1).padStart(8)} kB  ${path}`);
    const total = files.reduce((sum, [, bytes]) => sum + bytes, 0);
    expect(files.length).toBeGreaterThan(4);
    atMost(info, `whole transfer, WebGPU, ${encoding}`, total / 1000, 1000, "kB", true);
  });
