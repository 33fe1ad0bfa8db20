import { expect, type Page, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Lab } from "./lab";

async function openExplore(page: Page): Promise<Lab> {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  return lab;
}

const handles = (page: Page) => page.getByRole("list", { name: "Handles in the scene" });
const card = (page: Page) => page.getByRole("group", { name: "Selected handle" });

/** Where a handle is, as the words of the scene tell it. */
async function placeOf(page: Page, name: string): Promise<number[]> {
  const text = await handles(page).getByText(`${name} at `).innerText();
  return text
    .replace(/^.*\((.*)\).*$/, "$1")
    .split(", ")
    .map((part) => Number(part.replace("−", "-")));
}

/** Chooses a handle by the keyboard. */
async function choose(lab: Lab, name: string): Promise<void> {
  await lab.surface.focus();
  await lab.page.keyboard.press("Escape");
  await expect(async () => {
    await lab.page.keyboard.press("p");
    await expect(card(lab.page)).toContainText(name, { timeout: 300 });
  }).toPass();
}

/** The pixel of a handle: its label shows while it is chosen. */
async function pixelOf(lab: Lab, id: string, name: string): Promise<{ x: number; y: number }> {
  await choose(lab, name);
  await lab.settled();
  const at = await lab.pixelOf(id);
  await lab.page.keyboard.press("Escape");
  await expect(card(lab.page)).toBeHidden();
  return at;
}

async function draw(page: Page, what: string): Promise<void> {
  await page.getByRole("button", { name: "Draw…" }).click();
  await page.getByRole("button", { name: `Draw ${what}`, exact: true }).click();
  await expect(page.locator(".status")).toContainText("Escape stops");
}

async function addKeepOut(lab: Lab): Promise<void> {
  const group = await lab.openGroup("Placement");
  await group.getByRole("button", { name: "Keep-out box" }).click();
  await expect(handles(lab.page)).toContainText("Keep out 1, low corner");
}

const missing = (page: Page) => page.getByText(/^\d+ of \d+ ranges cannot be measured\.$/).first();

test("a corner of a keep-out box is dragged, and one undo takes it back", async ({ page }) => {
  const lab = await openExplore(page);
  await addKeepOut(lab);
  const from = await pixelOf(lab, "keep-out-0 low corner", "Keep out 1, low corner");
  const [low, high] = await Promise.all(
    ["low", "high"].map((one) => placeOf(page, `Keep out 1, ${one} corner`)),
  );
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x - 40, from.y + 25, { steps: 6 });
  await expect.poll(() => placeOf(page, "Keep out 1, low corner")).not.toEqual(low);
  await page.mouse.up();
  await expect(lab.status).toContainText(/Keep out 1, low corner moved to \(.*\) m/);
  const moved = await placeOf(page, "Keep out 1, low corner");
  expect(Math.hypot(moved[0] - low[0], moved[1] - low[1])).toBeGreaterThan(0.2);
  expect(moved[2]).toBe(low[2]);
  expect(await placeOf(page, "Keep out 1, high corner")).toEqual(high);
  expect(await lab.field("Keep out 1, low, x").inputValue()).toBe(String(moved[0]).replace("-", "−"));
  await page.keyboard.press("Control+z");
  await expect.poll(() => placeOf(page, "Keep out 1, low corner")).toEqual(low);
  await expect(lab.field("Keep out 1, low, x")).toBeVisible();
});

test("the middle takes the box along, Escape takes that back, and corners never cross", async ({ page }) => {
  const lab = await openExplore(page);
  await addKeepOut(lab);
  const at = await pixelOf(lab, "keep-out-0 middle", "Keep out 1, middle");
  const [low, high] = await Promise.all(
    ["low", "high"].map((one) => placeOf(page, `Keep out 1, ${one} corner`)),
  );
  const size = high.map((value, axis) => value - low[axis]);
  const dragTo = async (dx: number, dy: number) => {
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + dx, at.y + dy, { steps: 6 });
  };
  await dragTo(-60, 10);
  await expect.poll(() => placeOf(page, "Keep out 1, low corner")).not.toEqual(low);
  const now = await Promise.all(["low", "high"].map((one) => placeOf(page, `Keep out 1, ${one} corner`)));
  size.forEach((value, axis) => expect(now[1][axis] - now[0][axis]).toBeCloseTo(value, 6));
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect.poll(() => placeOf(page, "Keep out 1, low corner")).toEqual(low);

  await choose(lab, "Keep out 1, low corner");
  const x = card(page).getByRole("textbox", { name: "x" });
  await x.fill(String(high[0] + 5));
  await x.press("Enter");
  await expect(lab.status).toContainText("Keep out 1, low corner: x set to");
  expect((await placeOf(page, "Keep out 1, low corner"))[0]).toBeLessThan(high[0]);
  expect(await placeOf(page, "Keep out 1, high corner")).toEqual(high);
});

test("a wall drawn by hand takes ranges away and changes the bound", async ({ page }) => {
  const lab = await openExplore(page);
  const bound = page.getByRole("table", { name: "Bounds of one epoch" });
  await lab.openGroup("Range availability");
  await expect(missing(page)).toHaveText(/^0 of/);
  const [before, body, corner] = [
    await bound.innerText(),
    await lab.pixelOf("start"),
    await lab.anchorPixel(2),
  ];
  const middle = { x: (body.x + corner.x) / 2, y: (body.y + corner.y) / 2 };
  const along = { x: corner.y - body.y, y: body.x - corner.x };
  const share = 110 / Math.hypot(along.x, along.y);
  await draw(page, "a wall");
  await page.mouse.move(middle.x - share * along.x, middle.y - share * along.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + share * along.x, middle.y + share * along.y, { steps: 8 });
  await expect(missing(page)).not.toHaveText(/^0 of/);
  await page.mouse.up();
  await expect(lab.status).toContainText(/Wall 1 drawn from \(.*\) m to \(.*\) m/);
  await expect(card(page)).toContainText("Wall 1, middle");
  expect(await bound.innerText()).not.toBe(before);
  await expect(page.getByRole("group", { name: "Wall 1", exact: true })).toBeVisible();

  await lab.surface.focus();
  await page.keyboard.press("Delete");
  await expect(lab.status).toContainText("Wall 1 removed");
  await expect.poll(() => bound.innerText()).toBe(before);
  await page.keyboard.press("Control+z");
  await expect(handles(page)).toContainText("Wall 1, end A");
  await page.keyboard.press("Control+z");
  await expect(handles(page)).toHaveCount(0);
});

test("without dragging: a press where it begins and one where it ends; Escape stops", async ({ page }) => {
  const lab = await openExplore(page);
  const { x, y } = await lab.pixelOf("start");
  await draw(page, "a keep-out box");
  await page.mouse.click(x - 60, y + 60);
  await expect(lab.status).toContainText("Press where it ends");
  await page.mouse.move(x + 60, y + 90);
  await expect(page.locator("svg.labels polygon")).toHaveAttribute("points", /( .*){3}/);
  await page.keyboard.press("Escape");
  await expect(page.locator("svg.labels polygon")).toHaveAttribute("points", "");
  await expect(page.getByRole("button", { name: "Draw…" })).toBeVisible();
  await expect(handles(page)).toHaveCount(0);

  await draw(page, "a keep-out box");
  await page.mouse.click(x - 60, y + 60);
  await page.mouse.click(x + 60, y + 90);
  await expect(lab.status).toContainText("Keep out 1 drawn from");
  await expect(card(page)).toContainText("Keep out 1, middle");

  await draw(page, "where anchors may stand");
  await page.mouse.move(x - 100, y + 20);
  await page.mouse.down();
  await page.mouse.move(x + 100, y + 100, { steps: 5 });
  await expect(handles(page)).toContainText("Anchors within, middle");
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect(handles(page)).not.toContainText("Anchors within, middle");
});

test("a box is drawn in the plane; a scene that is seen from the side says that it has no floor", async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const lab = await openExplore(page);
  await page.getByRole("button", { name: "Front", exact: true }).click();
  const body = await lab.pixelOf("start");
  await draw(page, "a wall");
  await page.mouse.move(body.x - 60, body.y - 60);
  await page.mouse.down();
  await page.mouse.move(body.x + 60, body.y - 90, { steps: 4 });
  await page.mouse.up();
  await expect(lab.status).toContainText("The floor is not seen there");
  await expect(handles(page)).toHaveCount(0);
  await lab.surface.focus();
  await page.keyboard.press("Escape");

  await lab.openPreset("planar");
  const { x, y } = await lab.pixelOf("start");
  await draw(page, "a box that blocks sight");
  await page.mouse.move(x - 60, y - 60);
  await page.mouse.down();
  await page.mouse.move(x - 20, y + 60, { steps: 4 });
  await page.mouse.up();
  await expect(lab.status).toContainText(/Box 1 drawn from \([^,]*, [^,]*\) m/);
  await expect(card(page).getByRole("textbox")).toHaveCount(2);
});

test("by the keyboard alone: choose, move, lift, type, remove", async ({ page }) => {
  const lab = await openExplore(page);
  await addKeepOut(lab);
  await choose(lab, "Keep out 1, high corner");
  const before = await placeOf(page, "Keep out 1, high corner");
  await page.keyboard.press("PageUp");
  await expect
    .poll(async () => (await placeOf(page, "Keep out 1, high corner"))[2])
    .toBeCloseTo(before[2] + 0.1, 6);
  await page.keyboard.press("Shift+PageDown");
  await expect
    .poll(async () => (await placeOf(page, "Keep out 1, high corner"))[2])
    .toBeCloseTo(before[2] + 0.09, 6);
  await expect(lab.status).toContainText("Keep out 1, high corner moved to");
  await expect(handles(page)).toContainText("m, selected");
  await page.keyboard.press("Delete");
  await expect(lab.status).toContainText("Keep out 1 removed");
  await expect(handles(page)).toHaveCount(0);
});

test("a corner at an anchor's place yields to the anchor, and another press goes on to it", async ({
  page,
}) => {
  const lab = await openExplore(page);
  await lab.openGroup("Anchors");
  await lab.type("Anchor 1, z", "0.4");
  const group = await lab.openGroup("Placement");
  await group.getByRole("button", { name: "Limit anchors" }).click();
  const anchor = await lab.anchor(1);
  expect(anchor).toContain((await placeOf(page, "Anchors within, low corner")).join(", "));
  await lab.surface.focus();
  await page.keyboard.press("Escape");
  const { x, y } = await lab.anchorPixel(1);
  await page.mouse.click(x, y);
  await expect(lab.status).toContainText("Anchor 1 selected");
  await page.waitForTimeout(500);
  await page.mouse.click(x, y);
  await expect(card(page)).toContainText("Anchors within, low corner");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 30, y + 10, { steps: 4 });
  await page.mouse.up();
  await expect(lab.status).toContainText("Anchors within, low corner moved to");
  expect(anchor).toContain(await lab.anchor(1));
});

test("the names of boxes show, and Track has no handles", async ({ page }) => {
  const lab = await openExplore(page);
  const group = await lab.openGroup("Placement");
  for (const name of ["Body in a box", "Limit anchors", "Keep-out box"])
    await group.getByRole("button", { name }).click();
  for (const name of ["anchors within", "body within", "keep out 1"])
    await expect(page.locator("svg.labels")).toContainText(name);
  await expect(lab.surface).toHaveAccessibleName(/field/);
  await choose(lab, "Keep out 1, high corner");
  expect(await violations(page)).toEqual([]);
  for (const theme of ["dark", "projector"]) {
    await wear(page, theme);
    expect(await violations(page, "colours")).toEqual([]);
  }
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Track" }).click();
  await expect(lab.surface).toHaveAccessibleName(/tracks/);
  await expect(handles(page)).toHaveCount(0);
  await expect(page.getByRole("button", { name: "Draw…" })).toHaveCount(0);
});

test("what a search said of one preset is not said of the next", async ({ page }) => {
  const lab = await openExplore(page);
  const group = await lab.openGroup("Placement");
  const outcome = group.getByRole("status").filter({ hasText: "Best of 1:" });
  await lab.type("Searches", "1");
  await group.getByRole("button", { name: "Improve" }).click();
  await expect(outcome).toBeVisible();
  await lab.openPreset("three-anchors");
  await expect(outcome).toHaveCount(0);
});
