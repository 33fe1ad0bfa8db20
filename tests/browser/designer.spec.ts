import { expect, type Locator, type Page, test } from "@playwright/test";
import { readFileSync } from "node:fs";
import { violations, wear } from "./axe";
import { readTable } from "./csv";
import { Lab } from "./lab";

async function openDesigner(page: Page): Promise<Lab> {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(inset(page)).toBeVisible();
  return lab;
}

const designer = (page: Page) => page.getByRole("region", { name: "Body designer" });
const inset = (page: Page) => page.getByRole("application", { name: "Body in its own frame" });
const sensor = (page: Page, number: number) =>
  inset(page).getByRole("button", { name: new RegExp(`^Sensor ${number} at`) });
const undo = (page: Page) => page.getByRole("button", { name: "Undo" });

/** Undo would leave the lab: nothing has been done in it. */
const expectNoEdit = (page: Page) => expect(undo(page)).toHaveAttribute("title", /Lab Explore opened/);

/** Where the sensor is drawn. */
async function middle(locator: Locator): Promise<{ x: number; y: number }> {
  const box = await locator.boundingBox();
  if (!box) throw new Error("not on the page");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
const pixelOf = (page: Page, number: number) => middle(sensor(page, number).locator(".mark"));

/** Its coordinates as its name tells them. */
async function placeOf(page: Page, number: number): Promise<number[]> {
  const name = (await sensor(page, number).getAttribute("aria-label")) ?? "";
  return /\((.*)\)/
    .exec(name)![1]
    .split(", ")
    .map((text) => Number(text.replace("\u2212", "-")));
}

/** The bounds now, as they are shown: orientation in degrees, position in metres. */
const bounds = (page: Page) => designer(page).locator("[data-bound] .now").allInnerTexts();
const changes = (page: Page) => designer(page).locator("[data-bound] .change").allInnerTexts();

test("a dragged sensor changes the bounds while it moves, and one undo takes the drag back", async ({
  page,
}) => {
  const lab = await openDesigner(page);
  await designer(page).getByRole("button", { name: "front" }).click();
  const before = await bounds(page);
  const place = await placeOf(page, 5);
  expect(await changes(page)).toEqual(["", ""]);
  const from = await pixelOf(page, 5);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x, from.y - 30, { steps: 6 });
  await expect.poll(() => bounds(page)).not.toEqual(before);
  await expect.poll(async () => (await changes(page))[0]).toMatch(/% (better|worse)$/);
  // The picture stays still under the pointer.
  expect((await pixelOf(page, 5)).y).toBeGreaterThan(from.y - 34);
  expect((await pixelOf(page, 5)).y).toBeLessThan(from.y - 26);
  const shown = await bounds(page);
  const orientation = page
    .getByRole("table", { name: "Bounds of one epoch" })
    .locator('[data-at="body"] td')
    .first();
  await expect(orientation).toHaveText(shown[0]);
  await page.mouse.up();
  await expect(lab.status).toContainText("Sensor 5 moved to");
  const [x, y, z] = await placeOf(page, 5);
  expect([x, y]).toEqual(place.slice(0, 2));
  expect(z).toBeGreaterThan(place[2]);
  expect(z).toBe(Number(z.toFixed(2)));
  await page.keyboard.press("Control+z");
  await expect.poll(() => placeOf(page, 5)).toEqual(place);
  await expect.poll(() => bounds(page)).toEqual(before);
  await expect.poll(() => changes(page)).toEqual(["", ""]);
  await expectNoEdit(page);
});

test("the change is told against when the drag began, in the numbers that are shown", async ({ page }) => {
  await openDesigner(page);
  await designer(page).getByRole("button", { name: "top" }).click();
  const [before] = (await bounds(page)).map(Number);
  const from = await pixelOf(page, 1);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x - 25, from.y + 25, { steps: 5 });
  await page.mouse.up();
  await expect.poll(async () => (await changes(page))[0]).toMatch(/better$/);
  const [now] = (await bounds(page)).map(Number);
  const told = Number(/^([\d.]+) %/.exec((await changes(page))[0])?.[1]);
  // Three digits of either number, and the last one told.
  expect(Math.abs(100 * (1 - now / before) - told)).toBeLessThan(0.7);
  expect(told).toBeGreaterThan(2);
  await expect(designer(page).getByRole("status")).toContainText(
    `Orientation bound ${(await bounds(page))[0]} deg`,
  );
});

test("the body is turned beside its sensors, and the buttons set the view", async ({ page }) => {
  await openDesigner(page);
  const box = await inset(page).boundingBox();
  if (!box) throw new Error("no inset");
  const before = await pixelOf(page, 5);
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  await page.mouse.move(box.x + 70, box.y + 40, { steps: 4 });
  await page.mouse.up();
  expect(await pixelOf(page, 5)).not.toEqual(before);
  await designer(page).getByRole("button", { name: "aslant" }).click();
  await expect.poll(() => pixelOf(page, 5)).toEqual(before);
  await designer(page).getByRole("button", { name: "side" }).click();
  await expect(designer(page).getByRole("button", { name: "side" })).toHaveAttribute("aria-pressed", "true");
  await expectNoEdit(page);
});

test("sensors are chosen, moved, removed and added by the keyboard alone", async ({ page }) => {
  const lab = await openDesigner(page);
  await designer(page).getByRole("button", { name: "aslant" }).focus();
  await page.keyboard.press("Tab");
  await expect(sensor(page, 1)).toBeFocused();
  await page.keyboard.press("Tab");
  await expect(sensor(page, 2)).toBeFocused();
  await expect(sensor(page, 2)).toHaveAttribute("aria-pressed", "true");
  const [place, before] = [await placeOf(page, 2), await bounds(page)];
  for (let i = 0; i < 4; i++) await page.keyboard.press("ArrowUp");
  const [x, y, z] = await placeOf(page, 2);
  expect([x, y]).toEqual(place.slice(0, 2));
  expect(z).toBeGreaterThan(place[2] + 0.03);
  await expect.poll(() => bounds(page)).not.toEqual(before);
  await expect(lab.status).toContainText("Sensor 2 moved to");
  await page.keyboard.press("Delete");
  await expect(inset(page).getByRole("button")).toHaveCount(4);
  await expect(sensor(page, 2)).toBeFocused();
  await page.keyboard.press("a");
  await expect(inset(page).getByRole("button")).toHaveCount(5);
  for (let i = 0; i < 6; i++) await page.keyboard.press("Control+z");
  await expect.poll(() => placeOf(page, 2)).toEqual(place);
  await expect.poll(() => bounds(page)).toEqual(before);
  await expectNoEdit(page);
});

test("Escape takes a drag back; a sensor is sent by two presses without a drag", async ({ page }) => {
  await openDesigner(page);
  await designer(page).getByRole("button", { name: "top" }).click();
  const place = await placeOf(page, 1);
  const from = await pixelOf(page, 1);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 30, from.y, { steps: 3 });
  await expect.poll(() => placeOf(page, 1)).not.toEqual(place);
  await page.keyboard.press("Escape");
  await expect.poll(() => placeOf(page, 1)).toEqual(place);
  await page.mouse.up();
  await expectNoEdit(page);
  await designer(page).getByRole("button", { name: "Send" }).click();
  await page.mouse.click(from.x + 20, from.y - 20);
  await expect.poll(async () => (await placeOf(page, 1))[0]).toBeGreaterThan(place[0]);
  await page.keyboard.press("Control+z");
  await expect.poll(() => placeOf(page, 1)).toEqual(place);
});

test("the bodies with a name are one choice away, in the size that the body has", async ({ page }) => {
  const lab = await openDesigner(page);
  const topology = designer(page).getByLabel("Topology");
  const titles = (await topology.locator("option").allInnerTexts()).join();
  for (const name of ["yramid", "ube", "ross", "riangle", "od"]) expect(titles).toContain(name);
  const cube = topology.locator("option").filter({ hasText: /cube/i }).first();
  await topology.selectOption({ label: await cube.innerText() });
  await expect(inset(page).getByRole("button")).toHaveCount(8);
  await expect.poll(async () => (await changes(page))[0]).toMatch(/better|worse/);
  const rod = topology.locator("option").filter({ hasText: /rod/i }).first();
  await topology.selectOption({ label: await rod.innerText() });
  await expect.poll(() => changes(page)).toEqual(["lost", expect.anything()]);
  await expect(lab.plot("Orientation bound by size")).toContainText(
    "No size lets these sensors see every rotation",
  );
});

test("the curve against the size has its table and its numbers by keyboard", async ({ page }) => {
  const lab = await openDesigner(page);
  const plot = lab.plot("Orientation bound by size");
  await expect(plot).toContainText(/slope −1 .*size.*1.deg from [\d.]+.m/);
  await plot.getByRole("slider").focus();
  const reader = plot.getByRole("slider");
  const [angle] = await bounds(page);
  await expect(reader).toHaveAttribute("aria-valuetext", new RegExp(`^size 0\\.288 m, .* ${angle} deg`));
  const place = Number(await reader.getAttribute("aria-valuenow"));
  await page.keyboard.press("ArrowRight");
  expect(Number(await reader.getAttribute("aria-valuenow"))).toBeGreaterThan(place);
  await expect(plot.locator(".card")).toContainText(/size 0\.\d+ m/);
  await lab.plotMenu("Orientation bound by size", "Data table");
  const table = page.getByRole("dialog", { name: "Orientation bound by size, data table" });
  await expect(table.getByRole("columnheader").first()).toHaveText("size in m");
  const own = table.locator("tr[aria-current=true]");
  await expect(own.getByRole("rowheader")).toHaveText("0.288");
  await expect(own).toContainText(angle);
  expect(await violations(page)).toEqual([]);
});

test("the files of the curve have its axis", async ({ page }) => {
  const lab = await openDesigner(page);
  const save = async (choice: string) => {
    const download = page.waitForEvent("download");
    await lab.plotMenu("Orientation bound by size", `Save as ${choice}`);
    return readFileSync(await (await download).path(), choice === "PNG" ? "latin1" : "utf8");
  };
  const table = readTable(await save("CSV"));
  expect(table.names).toEqual(["size in m", "projected ranges in deg", "raw ranges in deg"]);
  const sizes = table.rows.map((row) => Number(row["size in m"]));
  expect(sizes.length).toBeGreaterThan(30);
  expect(sizes).toEqual(sizes.toSorted((a, b) => a - b));
  const slope = (row: number) =>
    Math.log(
      Number(table.rows[row + 1]["raw ranges in deg"]) / Number(table.rows[row]["raw ranges in deg"]),
    ) / Math.log(sizes[row + 1] / sizes[row]);
  expect(slope(0)).toBeCloseTo(-1, 2);
  const drawing = await save("SVG");
  for (const text of [">size in m<", ">0.1<", "projected ranges", "The scenario lies at size 0.28"])
    expect(drawing).toContain(text);
  expect(drawing).not.toMatch(/NaN|Infinity/);
  expect((await save("PNG")).slice(1, 4)).toBe("PNG");
});

test("mounting errors are clouds around the sensors, as wide as they are large", async ({ page }) => {
  const lab = await openDesigner(page);
  const cloud = inset(page).locator(".cloud");
  const heights = async () => {
    const dots = [...((await cloud.getAttribute("d")) ?? "").matchAll(/M([\d.-]+) ([\d.-]+)h0/g)];
    return dots.map((match) => Number(match[2]));
  };
  expect(await heights()).toEqual([]);
  await designer(page).getByRole("button", { name: "front" }).click();
  await lab.openGroup("Sensors on the body");
  await lab.type("Mounting error σe", "0.005");
  await expect.poll(async () => (await heights()).length).toBe(5 * 48);
  const { y } = await pixelOf(page, 5);
  const top = ((await inset(page).boundingBox())?.y ?? 0) - y;
  // Sensor by sensor within a trial: every fifth dot is of the last one.
  const spread = async () => {
    const off = (await heights()).filter((_, index) => index % 5 === 4).map((height) => height + top);
    return Math.hypot(...off) / Math.sqrt(off.length);
  };
  const narrow = await spread();
  await lab.type("Mounting error σe", "0.02");
  // The same draws, four times as far from where the sensor is meant to be.
  await expect.poll(async () => (await spread()) / narrow).toBeGreaterThan(3.5);
  expect((await spread()) / narrow).toBeLessThan(4.5);
});

test("a finger drags a sensor on a phone", async ({ browser }) => {
  const context = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true });
  const page = await context.newPage();
  await openDesigner(page);
  await sensor(page, 5).scrollIntoViewIfNeeded();
  await designer(page).getByRole("button", { name: "front" }).click();
  const before = await bounds(page);
  const from = await pixelOf(page, 5);
  const session = await context.newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", dy: number) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x: from.x, y: from.y + dy }],
    });
  await touch("touchStart", 0);
  for (const dy of [-10, -20, -30]) await touch("touchMove", dy);
  await touch("touchEnd", 0);
  await expect.poll(() => bounds(page)).not.toEqual(before);
  await undo(page).click();
  await expect.poll(() => bounds(page)).toEqual(before);
  await context.close();
});

test("axe finds nothing in any theme, at any size, with a sensor chosen", async ({ page }) => {
  await openDesigner(page);
  await sensor(page, 2).focus();
  expect(await violations(page)).toEqual([]);
  for (const theme of ["dark", "projector"]) {
    await wear(page, theme);
    expect(await violations(page, "colours")).toEqual([]);
  }
  for (const size of [
    { width: 1024, height: 768 },
    { width: 390, height: 844 },
  ]) {
    await page.setViewportSize(size);
    expect(await violations(page)).toEqual([]);
  }
});
