import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

test("dragging an anchor moves tracks, errors and bounds while the button is down", async ({ page }) => {
  const lab = await Lab.open(page);
  const [errors, bound, anchor] = [await lab.errors("uc-kf"), await lab.bound(), await lab.anchor(2)];
  const before = await lab.surface.screenshot();
  const plotBefore = await page.locator(".plots figure").first().screenshot();

  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 60, from.y - 50, { steps: 6 });
  await expect.poll(() => lab.anchor(2)).not.toBe(anchor);
  await expect.poll(() => lab.errors("uc-kf")).not.toEqual(errors);
  await expect.poll(() => lab.bound()).not.toEqual(bound);
  expect((await lab.surface.screenshot()).equals(before)).toBe(false);
  expect((await page.locator(".plots figure").first().screenshot()).equals(plotBefore)).toBe(false);
  await page.mouse.up();
  await expect(lab.status).toContainText("Anchor 2 moved to");
});

test("a drag in the plane keeps the height, with Shift it changes only the height", async ({ page }) => {
  const lab = await Lab.open(page);
  const coordinates = async () => (await lab.anchor(2)).match(/\((.*)\)/)?.[1].split(", ") ?? [];
  const start = await coordinates();
  await lab.drag(2, 40, -30);
  const level = await coordinates();
  expect(level[2]).toBe(start[2]);
  expect(level.slice(0, 2)).not.toEqual(start.slice(0, 2));

  await page.keyboard.down("Shift");
  await lab.drag(2, 0, -40);
  await page.keyboard.up("Shift");
  const lifted = await coordinates();
  expect(lifted.slice(0, 2)).toEqual(level.slice(0, 2));
  expect(Number(lifted[2])).toBeGreaterThan(Number(level[2]));
});

test("the handle above the selected anchor lifts it", async ({ page }) => {
  const lab = await Lab.open(page);
  const from = await lab.anchorPixel(2);
  await page.mouse.click(from.x, from.y);
  const before = await lab.anchor(2);
  const handle = 46 * 0.88; // pixels above the anchor, foreshortened by looking down on it
  await page.mouse.move(from.x, from.y - handle);
  await page.mouse.down();
  await page.mouse.move(from.x, from.y - handle - 40, { steps: 4 });
  await page.mouse.up();
  const [x, y, z] = before.match(/\((.*)\)/)?.[1].split(", ") ?? [];
  await expect.poll(() => lab.anchor(2)).toContain(`(${x}, ${y}, `);
  expect(await lab.anchor(2)).not.toContain(`, ${z})`);
});

test("a drag back to where it came from brings the same numbers back: the noise is the same", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const before = await lab.readout();
  const from = await lab.anchorPixel(3);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 70, from.y + 30, { steps: 5 });
  await expect.poll(() => lab.readout()).not.toBe(before);
  await page.mouse.move(from.x, from.y, { steps: 5 });
  await page.mouse.up();
  await expect.poll(() => lab.readout()).toBe(before);
});

test("a finger drags an anchor", async ({ browser }) => {
  const context = await browser.newContext({
    hasTouch: true,
    viewport: { width: 390, height: 844 },
  });
  const page = await context.newPage();
  const lab = await Lab.open(page);
  const before = await lab.anchor(2);
  const from = await lab.anchorPixel(2);
  const client = await context.newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", dx: number) =>
    client.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x: from.x + dx, y: from.y }],
    });
  await touch("touchStart", 0);
  for (const dx of [-10, -20, -30]) await touch("touchMove", dx);
  await touch("touchEnd", 0);
  await expect.poll(() => lab.anchor(2)).not.toBe(before);
  await context.close();
});
