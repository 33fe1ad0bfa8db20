import { expect, type Page, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Health } from "./health";
import { Lab } from "./lab";

/** The Explore lab, reached from Track as a visitor does. */
async function openExplore(page: Page): Promise<Lab> {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(bounds(page)).toBeVisible();
  return lab;
}

const bounds = (page: Page) => page.getByRole("table", { name: "Bounds of one epoch" });

/** Orientation in degrees and position in metres of the body, the typed point or the pointer. */
function read(page: Page, at: "body" | "typed" | "pointer"): Promise<string[]> {
  return bounds(page).locator(`[data-at="${at}"] td`).allInnerTexts();
}

test("going to Explore keeps the scene, and the way back leads to it", async ({ page }) => {
  const lab = await Lab.open(page);
  const readout = await lab.readout();
  await lab.type("Anchor 1, z", "0.4");
  await expect.poll(() => lab.readout()).not.toBe(readout);
  const tracked = await lab.readout();
  const switcher = page.getByRole("navigation", { name: "Labs" });
  await switcher.getByRole("button", { name: "Explore" }).click();
  await expect(bounds(page)).toBeVisible();
  expect(await lab.anchor(1)).toContain("0.4");
  await expect(page.getByRole("region", { name: "Timeline" })).toHaveCount(0);
  await expect(page.getByRole("region", { name: "Body designer" })).toBeVisible();
  await switcher.getByRole("button", { name: "Track" }).click();
  await expect.poll(() => lab.readout()).toBe(tracked);
});

test("dragging an anchor moves the bounds and the field while the button is down", async ({ page }) => {
  const lab = await openExplore(page);
  const before = await read(page, "body");
  for (const number of before) expect(Number(number)).toBeGreaterThan(0);
  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const picture = await lab.middle();
  await page.mouse.move(from.x - 90, from.y + 40, { steps: 6 });
  await expect.poll(() => read(page, "body")).not.toEqual(before);
  await expect.poll(async () => (await lab.middle()).equals(picture)).toBe(false);
  await page.mouse.up();
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await page.keyboard.press("Control+z");
  await expect.poll(() => read(page, "body")).toEqual(before);
});

test("bounds are proportional to the noise", async ({ page }) => {
  const lab = await openExplore(page);
  await lab.type("Noise level σ", "0.1");
  const [angle, position] = (await read(page, "body")).map(Number);
  await lab.type("Noise level σ", "0.2");
  await expect.poll(async () => Number((await read(page, "body"))[1]) / position).toBeCloseTo(2, 1);
  expect(Number((await read(page, "body"))[0]) / angle).toBeCloseTo(2, 1);
});

test("the field is read under the pointer and at a typed point", async ({ page }) => {
  const lab = await openExplore(page);
  const start = await lab.pixelOf("start");
  expect(await read(page, "pointer")).toEqual(["–", "–"]);
  await page.mouse.move(start.x + 60, start.y + 20);
  await expect.poll(async () => Number((await read(page, "pointer"))[1])).toBeGreaterThan(0);
  expect(await read(page, "pointer")).not.toEqual(await read(page, "body"));
  expect(await read(page, "typed")).toEqual(await read(page, "body"));
  await lab.type("Read at, x", "0.5");
  await expect.poll(() => read(page, "typed")).not.toEqual(await read(page, "body"));
});

test("a short reach and a wall take ranges away, by the keyboard alone", async ({ page }) => {
  const lab = await openExplore(page);
  const group = await lab.openGroup("Range availability");
  await expect(group).toContainText(/\b0 of \d+ ranges cannot be measured/);
  const before = await read(page, "body");
  await group.getByRole("checkbox", { name: "Anchor 1 reaches" }).focus();
  await page.keyboard.press("Space");
  const reach = lab.field("Anchor 1 reaches");
  await reach.press("Control+a");
  await page.keyboard.type("0.1");
  await page.keyboard.press("Enter");
  await expect(group).not.toContainText(/\b0 of \d+ ranges cannot/);
  await expect.poll(() => read(page, "body")).not.toEqual(before);
  await expect(page.locator(".scene .note")).toContainText("cannot be measured: dashed");
  await group.getByRole("button", { name: "Add a wall" }).focus();
  await page.keyboard.press("Enter");
  await expect(group.getByRole("group", { name: "Wall 1", exact: true })).toBeVisible();
  await group.getByRole("button", { name: "Remove wall 1" }).press("Enter");
  await expect(group.getByRole("group", { name: "Wall 1", exact: true })).toHaveCount(0);
});

test("a box that is ticked in vain is not ticked: a wall whose top would lie below its bottom", async ({
  page,
}) => {
  const lab = await openExplore(page);
  const group = await lab.openGroup("Range availability");
  await group.getByRole("button", { name: "Add a wall" }).click();
  await group.getByRole("checkbox", { name: "Wall 1, bottom" }).check();
  await lab.type("Wall 1, bottom", "3");
  const top = group.getByRole("checkbox", { name: "Wall 1, top" });
  await top.click();
  await expect(lab.alert).toContainText("The scenario stays as it was.");
  await expect(top).not.toBeChecked();
  await lab.type("Wall 1, bottom", "1");
  await top.click();
  await expect(top).toBeChecked();
  await expect(lab.field("Wall 1, top")).toHaveValue("2");
});

test("an anchor with a limit leaves with its limit", async ({ page }) => {
  const lab = await openExplore(page);
  const group = await lab.openGroup("Range availability");
  await group.getByRole("checkbox", { name: "Anchor 2 reaches" }).check();
  await lab.type("Anchor 2 reaches", "3");
  await page.getByRole("button", { name: "Remove anchor 1" }).click();
  await expect(group.getByRole("checkbox", { name: "Anchor 1 reaches" })).toBeChecked();
  await expect(lab.field("Anchor 1 reaches")).toHaveValue("3");
  await expect(lab.alert).toBeEmpty();
});

test("anchors in one plane hide a mirror image, and motions off the plane from projected ranges", async ({
  page,
}) => {
  const lab = await openExplore(page);
  const hidden = page.locator(".cause");
  await expect(hidden).toHaveText("Every small motion is seen.");
  await page.getByRole("button", { name: "Ceiling", exact: true }).click();
  await expect(hidden).toContainText("has the same ranges");
  await lab.pick("Ranges", "projected");
  await expect(hidden).toContainText("anchors in one plane");
  await expect.poll(() => read(page, "body")).toContain("–");
  await expect(page.locator(".scene .note")).toContainText("no range sees");
});

/** In the page: no worker can be started. */
function refuseWorkers(): void {
  window.Worker = class {
    constructor() {
      throw new Error("There are no workers here.");
    }
  } as unknown as typeof Worker;
}

test("at rest the field gets finer in workers, and where there are none in idle moments: to the same picture", async ({
  page,
  context,
}) => {
  test.setTimeout(120_000);
  const lab = await openExplore(page);
  await expect.poll(() => page.workers().some((worker) => worker.url().includes("field-worker"))).toBe(true);
  // The other page begins as this one did.
  await page.evaluate(() => localStorage.clear());
  const alone = await context.newPage();
  await alone.addInitScript(refuseWorkers);
  const other = await openExplore(alone);
  const pictureOf = ({ surface }: Lab) => surface.screenshot();
  const same = async () => (await pictureOf(lab)).equals(await pictureOf(other));
  await expect.poll(same, { timeout: 30_000 }).toBe(true);
  expect(alone.workers()).toEqual([]);
  // A page that is never idle keeps the first, coarse field.
  const busy = await context.newPage();
  await busy.addInitScript(refuseWorkers);
  await busy.addInitScript(() => void (window.requestIdleCallback = () => 0));
  await alone.evaluate(() => localStorage.clear());
  const coarse = await openExplore(busy);
  await coarse.settled();
  expect((await pictureOf(coarse)).equals(await pictureOf(lab))).toBe(false);
  await expect(other.alert).toBeEmpty();
});

test("every preset can be explored, with numbers or a reason why there are none", async ({ page }) => {
  const health = new Health(page);
  const lab = await openExplore(page);
  const presets = page.getByLabel("Preset", { exact: true });
  const names = await presets
    .locator("option")
    .evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value));
  expect(names.length).toBeGreaterThan(5);
  for (const name of names.filter((value) => value !== "")) {
    await lab.openPreset(name);
    await lab.settled();
    await expect(lab.alert).toBeEmpty();
    await health.expectGood(lab);
    const bound = await read(page, "body");
    const hidden = await page.locator(".cause").innerText();
    if (bound.includes("–")) expect(hidden, name).toContain("Not all is seen");
    else for (const number of bound) expect(Number(number), name).toBeGreaterThan(0);
  }
});

test("axe finds nothing in any theme, nor on a phone", async ({ page }) => {
  const lab = await openExplore(page);
  await lab.openGroups();
  await page.getByRole("button", { name: "Add a wall" }).click();
  await page.getByRole("button", { name: "Add a box" }).click();
  expect(await violations(page)).toEqual([]);
  for (const theme of ["dark", "projector"]) {
    await wear(page, theme);
    expect(await violations(page, "colours")).toEqual([]);
  }
  await page.setViewportSize({ width: 390, height: 844 });
  await lab.openSheet();
  expect(await violations(page)).toEqual([]);
});
