import { expect, type Page, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Lab } from "./lab";

async function openPlacement(page: Page) {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  const group = await lab.openGroup("Placement");
  return { lab, group };
}

/** Millimetres that the placement counts now. */
async function value(page: Page): Promise<number> {
  const [number, unit] = (await page.getByTestId("placement-value").innerText()).split(" ");
  return Number(number) * { mm: 1, m: 1000 }[unit]!;
}

test("Improve moves the free anchors to better places, one undo brings them back", async ({ page }) => {
  const { lab, group } = await openPlacement(page);
  const [before, first, second] = [await value(page), await lab.anchor(1), await lab.anchor(2)];
  expect(before).toBeGreaterThan(0);
  await group.getByRole("checkbox", { name: "Anchor 1 stays" }).check();
  await lab.type("Searches", "3");
  await group.getByRole("button", { name: "Improve" }).click();
  await expect(lab.status).toContainText("Anchors improved from", { timeout: 30_000 });
  const after = await value(page);
  expect(after).toBeLessThan(0.99 * before);
  await expect(group).toContainText("You are at the best found.");
  expect(await lab.anchor(1)).toBe(first);
  await page.keyboard.press("Control+z");
  await expect.poll(() => value(page)).toBe(before);
  expect(await lab.anchor(2)).toBe(second);
  const share = Math.round((100 * after) / before);
  await expect(group).toContainText(new RegExp(`You are at (${share - 1}|${share}|${share + 1}) %`));
});

test("Cancel stops the search and moves nothing", async ({ page }) => {
  const { lab, group } = await openPlacement(page);
  const before = await lab.anchor(2);
  await lab.type("Searches", "64");
  // Many places of the body: the search takes far longer than the way to the other button.
  await group.getByRole("button", { name: "Body in a box" }).click();
  await group.getByRole("button", { name: "Improve" }).click();
  await group.getByRole("button", { name: "Cancel" }).click();
  await expect(group).toContainText("Cancelled: no anchor has moved.");
  expect(await lab.anchor(2)).toBe(before);
});

test("limits, keep-out boxes and the region are typed, and axe finds nothing", async ({ page }) => {
  const { lab, group } = await openPlacement(page);
  for (const name of ["Body in a box", "Limit anchors", "Keep-out box"])
    await group.getByRole("button", { name }).click();
  await lab.settled();
  const mean = await value(page);
  await lab.pick("Places count by", "worst");
  await expect.poll(() => value(page)).toBeGreaterThan(mean);
  const all = await value(page);
  await lab.pick("Criterion", "E");
  await expect.poll(() => value(page)).toBeLessThan(all);
  await lab.type("Body within, high, x", "0.4");
  await expect(lab.alert).toBeEmpty();
  await expect(page.locator("svg.labels")).toContainText("keep out 1");
  expect(await violations(page)).toEqual([]);
  for (const theme of ["dark", "projector"]) {
    await wear(page, theme);
    expect(await violations(page, "colours")).toEqual([]);
  }
  await group.getByRole("button", { name: "Remove keep out 1" }).click();
  await expect(page.locator("svg.labels")).not.toContainText("keep out 1");
});
