import { expect, type Page, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Lab } from "./lab";
import { unpack } from "./scenario-link";

const SIGMA_E = "Mounting error σe";
const DOTS = "dots: where the sensors may sit";

async function openExplore(page: Page): Promise<Lab> {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await lab.openGroup("Sensors on the body");
  return lab;
}

/** The picture around the body, where nothing is written that the mounting error changes. */
async function aroundTheBody(lab: Lab): Promise<string> {
  const { x, y } = await lab.pixelOf("axis 0");
  await lab.settled();
  const clip = { x: x - 110, y: y - 110, width: 220, height: 220 };
  return (await lab.page.screenshot({ clip })).toString("base64");
}

const note = (page: Page) => page.locator(".scene .note");
/** The mounting error in the address; null before there is a scenario in it. */
function linked(page: Page): unknown {
  const { hash } = new URL(page.url());
  return hash === "" ? null : unpack(hash)["mounting_sigma"];
}

/** What a screen reader is told of the scene besides its anchors. */
const told = (page: Page) => page.getByRole("list", { name: "More in the scene" });

test("a typed mounting error draws its clouds around the sensors, and undo takes them away", async ({
  page,
}) => {
  const lab = await openExplore(page);
  const bounds = page.locator('[data-at="body"] td');
  const before = await bounds.allInnerTexts();
  await expect(note(page)).not.toContainText(DOTS);
  const bare = await aroundTheBody(lab);
  await lab.type(SIGMA_E, "0.05");
  await expect(note(page)).toContainText(DOTS);
  await expect(told(page)).toContainText("Sensors sit 0.0500 m off their places");
  await expect.poll(() => aroundTheBody(lab)).not.toBe(bare);
  const clouded = await aroundTheBody(lab);
  expect(await bounds.allInnerTexts(), "the bounds do not know of it").toEqual(before);
  await expect.poll(() => linked(page)).toBe(0.05);
  await lab.field(SIGMA_E).blur();
  await page.keyboard.press("Control+z");
  await expect(note(page)).not.toContainText(DOTS);
  await expect.poll(() => aroundTheBody(lab)).toBe(bare);
  await page.keyboard.press("Control+Shift+z");
  await expect.poll(() => aroundTheBody(lab)).toBe(clouded);
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
