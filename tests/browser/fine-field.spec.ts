import { readFileSync } from "node:fs";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { field_rows, initSync } from "../../web/page/src/wasm/explore/rangelab_explore.js";
import { Health } from "./health";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";
import { type Draft, unpack } from "./scenario-link";

const MODULE = new URL("../../web/page/src/wasm/explore/rangelab_explore_bg.wasm", import.meta.url);

test.beforeAll(() => void initSync({ module: readFileSync(MODULE) }));
test.use({ launchOptions: graphicsBrowser });

async function openExplore(page: Page, backend: string): Promise<Lab> {
  const lab = await Lab.open(page, `./?renderer=${backend}&theme=light`);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await expect(lab.scene).toHaveAttribute("data-backend", backend);
  return lab;
}

/** Keeps the texture that a kernel stores into, and its device. */
async function watchFields(page: Page): Promise<void> {
  await page.addInitScript(() => {
    type Prototype = Record<"createTexture", (...values: unknown[]) => unknown>;
    const { GPUDevice } = globalThis as unknown as Record<string, { prototype: Prototype }>;
    const kept: Record<string, unknown> = {};
    Object.assign(window, { kept });
    const { createTexture } = GPUDevice.prototype;
    GPUDevice.prototype.createTexture = function (...values) {
      const texture = createTexture.apply(this, values);
      const storage = 8;
      if ((values[0] as { usage: number }).usage & storage) Object.assign(kept, { texture, device: this });
      return texture;
    };
  });
}

interface Kept {
  readonly device: GpuDevice;
  readonly texture: { readonly width: number; readonly height: number };
}

/** What this test calls of WebGPU, which TypeScript does not know. */
interface GpuDevice {
  createBuffer(descriptor: object): { mapAsync(mode: number): Promise<void>; getMappedRange(): ArrayBuffer };
  createCommandEncoder(): { copyTextureToBuffer(...values: object[]): void; finish(): object };
  readonly queue: { submit(commands: object[]): void };
}

/** The grid that the device filled, row by row; negative where single precision does not tell. */
function readFine(page: Page): Promise<{ width: number; height: number; values: number[] }> {
  return page.evaluate(async () => {
    const { device, texture } = (window as unknown as { kept: Kept }).kept;
    const { width, height } = texture;
    const bytesPerRow = 256 * Math.ceil((4 * width) / 256);
    const [mapRead, copyTo] = [1, 8];
    const buffer = device.createBuffer({ size: bytesPerRow * height, usage: mapRead | copyTo });
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(mapRead);
    const padded = new Float32Array(buffer.getMappedRange());
    const rows = Array.from({ length: height }, (_, j) => (j * bytesPerRow) / 4);
    return { width, height, values: rows.flatMap((start) => [...padded.subarray(start, start + width)]) };
  });
}

/** Largest relative difference of what the device computed from what the engine computes for the same cells. */
function worstAgainstEngine(
  scenario: Draft,
  fine: { width: number; height: number; values: number[] },
): number {
  const resolution = Math.max(fine.width, fine.height);
  const exact = field_rows(JSON.stringify(scenario), resolution, 0, fine.height);
  expect(exact).toHaveLength(fine.values.length);
  const told = exact
    .map((value, at) => (value < 1e30 && fine.values[at] >= 0 ? at : -1))
    .filter((at) => at >= 0);
  expect(told.length).toBeGreaterThan(exact.length / 2);
  return told.reduce((worst, at) => Math.max(worst, Math.abs(fine.values[at] / exact[at] - 1)), 0);
}

const hashOf = (page: Page): string => new URL(page.url()).hash;

/** The renderer says on its canvas that it draws what the device computed. */
const fine = (page: Page): Locator => page.locator(".host canvas[data-fine-field]");

test("WebGPU draws a finer field, another one once an anchor has moved, and it is the engine's", async ({
  page,
}) => {
  test.setTimeout(180_000);
  const warnings: string[] = [];
  page.on("console", (message) => message.type() === "warning" && warnings.push(message.text()));
  const health = new Health(page);
  await watchFields(page);
  const lab = await openExplore(page, "webgpu");
  await expect(fine(page)).toHaveCount(1, { timeout: 60_000 });
  const picture = await lab.surface.screenshot();
  const before = hashOf(page);
  await lab.drag(2, -60, 40);
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await expect(fine(page)).toHaveCount(1, { timeout: 60_000 });
  expect((await lab.surface.screenshot()).equals(picture)).toBe(false);
  await expect.poll(() => hashOf(page)).not.toBe(before);
  const scenario = unpack(hashOf(page));
  const computed = await readFine(page);
  expect(worstAgainstEngine(scenario, computed)).toBeLessThan(1e-3);
  // Ranges noisier by 0.2 % would be seen.
  const { noise } = scenario;
  const spoiled = { ...scenario, noise: { ...noise, sigma: 1.002 * noise.sigma } };
  expect(worstAgainstEngine(spoiled, computed)).toBeGreaterThan(1e-3);
  expect(warnings.filter((text) => text.includes("field"))).toEqual([]);
  await health.expectGood(lab);
});

test("WebGL2 and the plain canvas keep to the coarse field", async ({ page }) => {
  test.setTimeout(180_000);
  const health = new Health(page);
  for (const backend of ["webgl", "canvas2d"]) {
    const lab = await openExplore(page, backend);
    await lab.drag(2, -60, 40);
    await expect(lab.status).toContainText("Anchor 2 moved to");
    await expect(fine(page)).toHaveCount(0);
    await health.expectGood(lab);
  }
});
