import { expect, test } from "@playwright/test";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from "node:fs";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync, inflateSync } from "node:zlib";
import { Lab } from "./lab";

const PAGE = fileURLToPath(new URL("../../web/page/", import.meta.url));
const TYPES: Record<string, string> = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
const PART = `<p class="second">A part of the second lab</p>`;
const SECOND = `
  import { preset, presets, track } from "../../engine";
  import { rigidBody } from "../../rigid-body/family";
  import Part from "./Part.svelte";
  export const lab = {
    name: "second", title: "Second", order: 99, family: { ...rigidBody }, presets, preset, firstPreset: "tracking-paper",
    compute: (scenario) => ({ ...track(scenario), estimators: [], bounds: [] }),
    layers: [], labels: () => [], note: () => "", told: () => [], plots: () => [], marks: () => [],
    describe: (run) => "The second lab ran " + run.steps + " steps.",
    Controls: Part, Readout: Part,
  };`;

/** The page built with one folder more. */
function buildWithSecondLab(folder: string): string {
  mkdirSync(folder, { recursive: true });
  for (const part of ["index.html", "package.json", "vite.config.ts", "svelte.config.js", "src"])
    cpSync(join(PAGE, part), join(folder, part), { recursive: true });
  symlinkSync(join(PAGE, "node_modules"), join(folder, "node_modules"));
  mkdirSync(join(folder, "src/labs/second"));
  writeFileSync(join(folder, "src/labs/second/index.ts"), SECOND);
  writeFileSync(join(folder, "src/labs/second/Part.svelte"), PART);
  execFileSync(join(PAGE, "node_modules/.bin/vite"), ["build"], { cwd: folder, stdio: "pipe" });
  return join(folder, "dist");
}

test("a lab is added by adding its folder: header, links, undo and scene know it", async ({
  page,
  context,
}, info) => {
  const built = buildWithSecondLab(info.outputPath("page"));
  await context.route("http://second.test/**", (route) => {
    const { pathname } = new URL(route.request().url());
    const path = join(built, pathname === "/" ? "index.html" : pathname);
    const contentType = TYPES[extname(path)] ?? "application/wasm";
    return route.fulfill({ body: readFileSync(path), contentType });
  });
  const address = "http://second.test/?renderer=canvas2d&theme=light";
  const lab = await Lab.open(page, address);
  const readout = await lab.readout();
  const switcher = page.getByRole("navigation", { name: "Labs" });
  await expect(switcher.getByRole("button", { name: "Track" })).toHaveAttribute("aria-current", "page");

  await switcher.getByRole("button", { name: "Second" }).click();
  await expect(lab.status).toContainText("The second lab ran");
  await expect(page.locator(".second").first()).toBeVisible();
  await expect(switcher.getByRole("button", { name: "Second" })).toHaveAttribute("aria-current", "page");
  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#v1\./);

  const other = await Lab.open(await context.newPage(), address + new URL(page.url()).hash);
  await expect(other.status).toContainText("The second lab ran");

  await page.keyboard.press("Control+z");
  await expect.poll(() => lab.readout()).toBe(readout);
  await expect(page.locator(".second")).toHaveCount(0);
});

test("a link to a lab that is not there says so", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "5");
  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#v1\./);
  const packed = Buffer.from(new URL(page.url()).hash.slice(4), "base64url");
  const scenario = { ...JSON.parse(inflateSync(packed).toString()), view: { lab: "moon" } };
  const moon = `#v1.${deflateSync(JSON.stringify(scenario)).toString("base64url")}`;
  await page.evaluate((hash) => (location.hash = hash), moon);
  await expect(lab.alert).toContainText("lab “moon”");
  await expect(lab.field("Seed")).toHaveValue("5");
});
