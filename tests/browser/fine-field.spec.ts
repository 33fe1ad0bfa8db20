import { expect, type Locator, type Page, test } from "@playwright/test";
import { Health } from "./health";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

async function openExplore(page: Page, backend: string): Promise<Lab> {
  const lab = await Lab.open(page, `./?renderer=${backend}&theme=light`);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await expect(lab.scene).toHaveAttribute("data-backend", backend);
  return lab;
}

/**
 * Keeps what the page hands to the graphics device and what comes of it: the last coarse grid, and the texture that a
 * kernel stores into.
 */
async function watchFields(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { GPUDevice, GPUQueue } = globalThis as unknown as Record<string, { prototype: Prototype }>;
    type Prototype = Record<"createTexture" | "writeTexture", (...values: unknown[]) => unknown>;
    const kept: Record<string, unknown> = {};
    Object.assign(window, { kept });
    const { createTexture } = GPUDevice.prototype;
    GPUDevice.prototype.createTexture = function (...values) {
      const texture = createTexture.apply(this, values);
      const storage = 8;
      if ((values[0] as { usage: number }).usage & storage) Object.assign(kept, { texture, device: this });
      return texture;
    };
    const { writeTexture } = GPUQueue.prototype;
    GPUQueue.prototype.writeTexture = function (...values) {
      const { buffer, byteOffset, byteLength } = values[1] as Uint8Array;
      kept["coarse"] = new Float32Array(buffer.slice(byteOffset, byteOffset + byteLength));
      kept["size"] = values[3];
      return writeTexture.apply(this, values);
    };
  });
}

interface Kept {
  readonly coarse: Float32Array;
  readonly size: { readonly width: number; readonly height: number };
  readonly device: GpuDevice;
  readonly texture: { readonly width: number; readonly height: number };
}

/** What this test calls of WebGPU, which TypeScript does not know. */
interface GpuDevice {
  createBuffer(descriptor: object): { mapAsync(mode: number): Promise<void>; getMappedRange(): ArrayBuffer };
  createCommandEncoder(): { copyTextureToBuffer(...values: object[]): void; finish(): object };
  readonly queue: { submit(commands: object[]): void };
}

/** Fine over coarse values at 64 places that are resolved and bounded: least and largest. */
function quotients(page: Page): Promise<[least: number, largest: number]> {
  return page.evaluate(async () => {
    const { coarse, size, device, texture } = (window as unknown as { kept: Kept }).kept;
    const bytesPerRow = 256 * Math.ceil((4 * texture.width) / 256);
    const [mapRead, copyTo] = [1, 8];
    const buffer = device.createBuffer({ size: bytesPerRow * texture.height, usage: mapRead | copyTo });
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [texture.width, texture.height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(mapRead);
    const fine = new Float32Array(buffer.getMappedRange());
    const found: number[] = [];
    for (let place = 0; place < 64; place++) {
      const [s, t] = [((place % 8) + 0.5) / 8, (Math.floor(place / 8) + 0.5) / 8];
      const at = (width: number, height: number, stride: number) =>
        Math.floor(t * height) * stride + Math.floor(s * width);
      const value = fine[at(texture.width, texture.height, bytesPerRow / 4)];
      const other = coarse[at(size.width, size.height, size.width)];
      if (value >= 0 && other < 1e30) found.push(value / other);
    }
    if (found.length < 32) throw new Error(`only ${found.length} places of 64 are resolved`);
    return [Math.min(...found), Math.max(...found)];
  });
}

/** The renderer says on its canvas that it draws what the device computed. */
const fine = (page: Page): Locator => page.locator(".host canvas[data-fine-field]");

test("WebGPU draws a finer field, and another one once an anchor has moved", async ({ page }) => {
  test.setTimeout(180_000);
  const warnings: string[] = [];
  page.on("console", (message) => message.type() === "warning" && warnings.push(message.text()));
  const health = new Health(page);
  await watchFields(page);
  const lab = await openExplore(page, "webgpu");
  await expect(fine(page)).toHaveCount(1, { timeout: 60_000 });
  const picture = await lab.surface.screenshot();
  await lab.drag(2, -60, 40);
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await expect(fine(page)).toHaveCount(1, { timeout: 60_000 });
  expect((await lab.surface.screenshot()).equals(picture)).toBe(false);
  // Half a cell of the coarser grid lies between the places compared.
  const [least, largest] = await quotients(page);
  expect(least).toBeGreaterThan(0.9);
  expect(largest).toBeLessThan(1.1);
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
