import { expect, type Page, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Lab } from "./lab";
import { unpack } from "./scenario-link";

const SIGMA_E = "Mounting error σe";
const DOTS = "dots: where the sensors may sit";

/** Draws nothing else as discs of this radius. */
const DOT = 1.5;
/** Places that are shown of each of the five sensors. */
const DOTS_DRAWN = 48 * 5;

async function openExplore(page: Page): Promise<Lab> {
  await page.addInitScript(watchDiscs);
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await lab.openGroup("Sensors on the body");
  return lab;
}

/** Keeps the discs of the last picture: x, y and radius of each in pixels. A picture begins with its ground. */
function watchDiscs(): void {
  const plain = CanvasRenderingContext2D.prototype;
  const { fillRect, arc } = plain;
  const discs: number[][] = [];
  Object.assign(window, { discs });
  plain.fillRect = function (x, y, width, height) {
    if (this.canvas.closest(".scene") && width === this.canvas.width) discs.length = 0;
    fillRect.call(this, x, y, width, height);
  };
  plain.arc = function (x, y, radius, ...rest) {
    if (this.canvas.closest(".scene")) discs.push([x, y, radius]);
    arc.call(this, x, y, radius, ...rest);
  };
}

/** The dots of the clouds in the scene, pixels from the corner of its surface. */
async function dots(page: Page): Promise<number[][]> {
  const discs = await page.evaluate(() => (window as unknown as { discs: number[][] }).discs);
  return discs.filter(([, , radius]) => Math.abs(radius - DOT) < 1e-6);
}

const note = (page: Page) => page.locator(".scene .note");
/** The mounting error in the address; null before there is a scenario in it. */
function linked(page: Page): unknown {
  const { hash } = new URL(page.url());
  return hash === "" ? null : unpack(hash)["mounting_sigma"];
}

/** What a screen reader is told of the scene besides its anchors. */
const told = (page: Page) => page.getByRole("list", { name: "More in the scene" });

/** Root mean square distance of dots from their middle. */
function spread(points: readonly number[][]): number {
  const middle = [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
  const squares = points.map(([x, y]) => (x - middle[0]) ** 2 + (y - middle[1]) ** 2);
  return Math.sqrt(squares.reduce((sum, square) => sum + square, 0) / points.length);
}

test("a typed mounting error draws its clouds around the sensors, and undo takes them away", async ({
  page,
}) => {
  const lab = await openExplore(page);
  const bounds = page.locator('[data-at="body"] td');
  const before = await bounds.allInnerTexts();
  await expect(note(page)).not.toContainText(DOTS);
  expect(await dots(page)).toEqual([]);
  await lab.type(SIGMA_E, "0.05");
  await expect(note(page)).toContainText(DOTS);
  await expect(told(page)).toContainText("Sensors sit 0.0500 m off their places");
  await expect.poll(async () => (await dots(page)).length).toBe(DOTS_DRAWN);
  const near = await dots(page);
  expect(await bounds.allInnerTexts(), "the bounds do not know of it").toEqual(before);
  await expect.poll(() => linked(page)).toBe(0.05);
  await lab.field(SIGMA_E).blur();
  await page.keyboard.press("Control+z");
  await expect(note(page)).not.toContainText(DOTS);
  await expect.poll(() => dots(page)).toEqual([]);
  await page.keyboard.press("Control+Shift+z");
  await expect.poll(() => dots(page)).toEqual(near);
  await lab.type(SIGMA_E, "0.2");
  await expect.poll(async () => spread(await dots(page)) / spread(near)).toBeGreaterThan(1.8);
});

test("estimators are off by what they are not told, and a link brings the error along", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.openGroup("Sensors on the body");
  const exact = await lab.readout();
  await lab.type(SIGMA_E, "0.1");
  await expect.poll(() => lab.readout()).not.toBe(exact);
  await expect(told(page)).toContainText("estimators and bounds do not know of it");
  const displaced = await lab.readout();
  await expect.poll(() => linked(page)).toBe(0.1);
  await page.reload();
  await expect.poll(() => lab.readout()).toBe(displaced);
  await expect(lab.field(SIGMA_E)).toHaveValue("0.1");
  await lab.type(SIGMA_E, "-1");
  await expect(lab.alert).toContainText("from 0 to 1e9 m");
  expect(await lab.readout()).toBe(displaced);
});

test("axe finds nothing in any theme", async ({ page }) => {
  const lab = await openExplore(page);
  await lab.type(SIGMA_E, "0.05");
  await expect(note(page)).toContainText(DOTS);
  expect(await violations(page)).toEqual([]);
  for (const theme of ["dark", "projector"]) {
    await wear(page, theme);
    expect(await violations(page, "colours")).toEqual([]);
  }
});
