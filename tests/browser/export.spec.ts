import { readFile } from "node:fs/promises";
import { expect, type Download, type Page, test } from "@playwright/test";
import { readTable } from "./csv";
import { Lab } from "./lab";

async function save(lab: Lab, title: string, format: "CSV" | "PNG" | "SVG"): Promise<Download> {
  const download = lab.page.waitForEvent("download");
  await lab.plotMenu(title, `Save as ${format}`);
  await expect(lab.status).toContainText("Saved as");
  return download;
}

async function bytes(download: Download): Promise<Buffer> {
  return readFile(await download.path());
}

/** The address that the page itself would share. */
async function sharedLink(page: Page): Promise<string> {
  await page.getByRole("button", { name: "Share" }).click();
  await expect(page.locator(".status")).toContainText("Link copied");
  return page.evaluate(() => navigator.clipboard.readText());
}

test("the table of a plot has every step, its units, seed and link", async ({ page }) => {
  const lab = await Lab.open(page);
  const count = Number(await lab.step.innerText());
  const shown = (await lab.errors("uc-kf"))[0];
  const download = await save(lab, "Orientation error", "CSV");
  expect(download.suggestedFilename()).toBe("rangelab-track-room-orientation-error-seed-1.csv");
  const { comments, names, rows } = readTable((await bytes(download)).toString("utf8"));
  expect(comments).toContain(`Link: ${await sharedLink(page)}`);
  expect(comments).toContain("Seed: 1");
  expect(names).toEqual(
    expect.arrayContaining(["step", "time in s", "UC-KF in deg", "posterior CRB in deg"]),
  );
  expect(rows).toHaveLength(count);
  expect(Number(rows[count - 1]["UC-KF in deg"]).toPrecision(3)).toBe(shown);
});

test("the drawing of a plot is vectors with text, and opens", async ({ page }) => {
  const lab = await Lab.open(page);
  const download = await save(lab, "Defect ‖QᵀQ − I‖", "SVG");
  expect(download.suggestedFilename()).toMatch(/^rangelab-track-room-defect-.*-seed-1\.svg$/);
  const svg = (await bytes(download)).toString("utf8");
  const link = await sharedLink(page);
  const found = await page.evaluate((text) => {
    const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
    return {
      error: drawing.querySelector("parsererror")?.textContent ?? null,
      metadata: drawing.querySelector("metadata")?.textContent,
      href: drawing.querySelector("a")?.getAttribute("href"),
      texts: [...drawing.querySelectorAll("text")].map((node) => node.textContent),
      images: drawing.querySelectorAll("image").length,
      paths: drawing.querySelectorAll("path").length,
    };
  }, svg);
  expect(found.error).toBeNull();
  expect([found.metadata, found.href]).toEqual([link, link]);
  expect(found.texts).toEqual(expect.arrayContaining(["time in s", "KF", "UC-KF", "ET-KF", "ε = 0.15"]));
  expect(found.images).toBe(0);
  expect(found.paths).toBeGreaterThan(3);
});

test("the picture of a plot is painted twice as sharp on the theme's ground and carries the link", async ({
  page,
}) => {
  const lab = await Lab.open(page, "./?renderer=canvas2d&theme=dark");
  const png = await bytes(await save(lab, "Position error", "PNG"));
  expect(png.toString("latin1")).toContain(`tEXtSource\0${await sharedLink(page)}`);
  const seen = await page.evaluate(
    async (data) => {
      const bitmap = await createImageBitmap(await (await fetch(data)).blob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d")!;
      context.drawImage(bitmap, 0, 0);
      const { data: pixels } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      const colors = new Set<number>();
      for (let at = 0; at < pixels.length; at += 4)
        colors.add((pixels[at] << 16) | (pixels[at + 1] << 8) | pixels[at + 2]);
      const surface = getComputedStyle(document.documentElement).getPropertyValue("--surface").trim();
      const corner = `#${((pixels[0] << 16) | (pixels[1] << 8) | pixels[2]).toString(16).padStart(6, "0")}`;
      return { width: bitmap.width, height: bitmap.height, colors: colors.size, surface, corner };
    },
    `data:image/png;base64,${png.toString("base64")}`,
  );
  expect([seen.width, seen.height]).toEqual([1920, 1080]);
  expect(seen.corner).toBe(seen.surface);
  expect(seen.colors).toBeGreaterThan(50);
});

test("the link in a file opens the very same numbers", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "4711");
  await expect(lab.status).toContainText("Seed");
  const before = await lab.readout();
  const text = (await bytes(await save(lab, "NEES / dof", "CSV"))).toString("utf8");
  const link = /Link: (\S+)/.exec(text)?.[1] ?? "";
  const other = await page.context().newPage();
  const reopened = await Lab.open(other, link.replace("/#", "/?renderer=canvas2d#"));
  await expect.poll(() => reopened.readout()).toBe(before);
});

test("files are reached by keyboard", async ({ page }) => {
  await Lab.open(page);
  await page.getByRole("button", { name: "Orientation error: scale, table, files" }).focus();
  await page.keyboard.press("Enter");
  const names: string[] = [];
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press("Tab");
    names.push(await page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? ""));
  }
  for (const format of ["CSV", "PNG", "SVG"]) expect(names).toContain(`Save as ${format}`);
});
