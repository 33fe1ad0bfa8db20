import { expect, type Page, test } from "@playwright/test";
import { inked } from "./health";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

const backends = ["webgpu", "webgl", "canvas2d"] as const;

const readouts: Record<string, string> = {};
const shares: Record<string, number> = {};

for (const backend of backends) {
  test(`${backend} draws the scene, follows a drag, and shows the same numbers`, async ({ page }) => {
    test.setTimeout(180_000);
    const lab = await Lab.open(page, `./?renderer=${backend}&theme=light`);
    await expect(lab.scene).toHaveAttribute("data-backend", backend);
    readouts[backend] = await lab.readout();
    // What lies over the canvas is no evidence of drawing.
    await page.addStyleTag({
      content: ".scene > :not(.surface), svg.labels { visibility: hidden }",
    });
    await expect.poll(() => inked(lab)).toBeGreaterThan(0.005);
    shares[backend] = await inked(lab);
    const before = await lab.surface.screenshot();
    await lab.drag(2, 60, -40);
    await expect(lab.status).toContainText("Anchor 2 moved");
    expect((await lab.surface.screenshot()).equals(before)).toBe(false);
  });
}

test("all three agree on the numbers and, within a quarter, on the ink", () => {
  for (const backend of backends) {
    expect(readouts[backend]).toBe(readouts["canvas2d"]);
    expect(shares[backend] / shares["canvas2d"]).toBeGreaterThan(0.75);
    expect(shares[backend] / shares["canvas2d"]).toBeLessThan(1.25);
  }
});

test("a browser whose GPU has no adapter falls back by itself", async ({ page }) => {
  test.setTimeout(180_000);
  await page.addInitScript(() => {
    Object.defineProperty(navigator, "gpu", {
      value: { requestAdapter: () => Promise.resolve(null) },
    });
  });
  const lab = await Lab.open(page, "./?theme=light");
  await expect(lab.scene).toHaveAttribute("data-backend", "webgl");
});

test("a browser without any graphics device gets the plain canvas", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, "gpu", { value: undefined });
    const original = HTMLCanvasElement.prototype.getContext as (kind: string, options?: unknown) => unknown;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      kind: string,
      options?: unknown,
    ) {
      return kind.startsWith("webgl") ? null : original.call(this, kind, options);
    } as typeof HTMLCanvasElement.prototype.getContext;
  });
  const lab = await Lab.open(page, "./?theme=light");
  await expect(lab.scene).toHaveAttribute("data-backend", "canvas2d");
  expect(await inked(lab)).toBeGreaterThan(0.005);
});

for (const [what, answer] of [
  ["throws", "throw new Error('no adapter today')"],
  ["refuses", "return Promise.reject(new Error('no adapter today'))"],
  ["never answers", "return new Promise(() => {})"],
] as const)
  test(`a browser whose request for an adapter ${what} falls back by itself`, async ({ page }) => {
    test.setTimeout(180_000);
    await page.addInitScript((body) => {
      Object.defineProperty(navigator, "gpu", { value: { requestAdapter: new Function(body) } });
    }, answer);
    const lab = await Lab.open(page, "./?theme=light");
    await expect(lab.scene).toHaveAttribute("data-backend", "webgl");
    expect(await lab.readout()).toBe(readouts["canvas2d"] ?? (await lab.readout()));
  });

/** Every device that the page opens from now on can be destroyed from outside. */
async function keepDevices(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const kept: { destroy(): void }[] = [];
    Object.assign(window, { kept });
    const prototype = (globalThis as unknown as { GPUAdapter: { prototype: Record<string, unknown> } })
      .GPUAdapter.prototype;
    const open = prototype["requestDevice"] as (...values: unknown[]) => Promise<{ destroy(): void }>;
    prototype["requestDevice"] = async function (...values: unknown[]) {
      const device = await open.apply(this, values);
      kept.push(device);
      return device;
    };
  });
}
const destroyDevice = (page: Page) =>
  page.evaluate(() => {
    document.querySelector(".host canvas")?.setAttribute("data-old", "");
    (window as unknown as { kept: { destroy(): void }[] }).kept.at(-1)?.destroy();
  });

test("a lost WebGPU device is replaced by itself, the scene and its edits stay", async ({ page }) => {
  test.setTimeout(180_000);
  await keepDevices(page);
  const lab = await Lab.open(page, "./?renderer=webgpu&theme=light");
  await expect(lab.scene).toHaveAttribute("data-backend", "webgpu");
  await lab.drag(2, 40, -20);
  const [anchor, readout] = [await lab.anchor(2), await lab.readout()];
  await destroyDevice(page);
  await expect(page.locator(".host canvas[data-old]")).toHaveCount(0);
  await expect(lab.scene).toHaveAttribute("data-backend", "webgpu", { timeout: 60_000 });
  await expect.poll(() => inked(lab)).toBeGreaterThan(0.005);
  expect(await lab.anchor(2)).toBe(anchor);
  expect(await lab.readout()).toBe(readout);
});

test("a device that is lost again and again is given up for the plain canvas", async ({ page }) => {
  test.setTimeout(180_000);
  await keepDevices(page);
  const lab = await Lab.open(page, "./?renderer=webgpu&theme=light");
  for (let i = 0; i < 3; i++) {
    await expect(lab.scene).toHaveAttribute("data-backend", "webgpu", { timeout: 60_000 });
    await destroyDevice(page);
    await expect(page.locator(".host canvas[data-old]")).toHaveCount(0);
  }
  await expect(lab.scene).toHaveAttribute("data-backend", "canvas2d", { timeout: 60_000 });
  expect(await inked(lab)).toBeGreaterThan(0.005);
});

test("a lost WebGL context is replaced and the scene drawn again", async ({ page }) => {
  test.setTimeout(180_000);
  const lab = await Lab.open(page, "./?renderer=webgl&theme=light");
  const marked = await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>(".host canvas");
    canvas?.setAttribute("data-old", "");
    canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
    return canvas !== null;
  });
  expect(marked).toBe(true);
  await expect(page.locator(".host canvas[data-old]")).toHaveCount(0);
  await expect(lab.scene).toHaveAttribute("data-backend", "webgl", { timeout: 60_000 });
  await expect.poll(() => inked(lab)).toBeGreaterThan(0.005);
});
