import { expect, type Locator, test } from "@playwright/test";
import { Lab } from "./lab";

async function follow(lab: Lab, path: string): Promise<Locator> {
  const group = await lab.openGroup("Motion of the body");
  await group.getByLabel("Path", { exact: true }).selectOption({ label: path });
  await expect(lab.status).toContainText(`Path: ${path}`);
  return group;
}

/** Where the body is, as the hidden twin of the scene says it. */
async function bodyAt(lab: Lab, step: "Home" | "End"): Promise<number[]> {
  const { page } = lab;
  // In a field these keys move the caret.
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press(step);
  await lab.settled();
  const twin = page.getByRole("group", { name: "What the scene shows" });
  const text = ((await twin.textContent()) ?? "").replaceAll("−", "-");
  const [, point] = text.match(/Body at \(([^)]*)\)/) ?? [];
  return point.split(", ").map(Number);
}

test("without disturbances the body is back at the start after a round", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.openGroup("True start");
  const start = await Promise.all(["x", "y", "z"].map((axis) => lab.field(`Position, ${axis}`).inputValue()));
  for (const path of ["turn", "figure eight"]) {
    await follow(lab, path);
    await lab.type("Turn rate σω", "0");
    const group = await lab.openGroup("Motion of the body");
    await group.getByRole("textbox", { name: "Shift per step σt" }).fill("0");
    await page.keyboard.press("Enter");
    const end = await bodyAt(lab, "End");
    end.forEach((value, axis) => expect(value).toBeCloseTo(Number(start[axis]), 5));
    const early = await bodyAt(lab, "Home");
    expect(Math.hypot(...early.map((value, axis) => value - end[axis]))).toBeGreaterThan(0.01);
  }
});

test("a helix climbs, to the other side and by what is typed", async ({ page }) => {
  const lab = await Lab.open(page);
  const group = await follow(lab, "helix");
  await group.getByRole("textbox", { name: "Shift per step σt" }).fill("0");
  await page.keyboard.press("Enter");
  await lab.type("Climb a turn", "0.5");
  await lab.type("Period", "3");
  const [, , low] = await bodyAt(lab, "Home");
  const [, , high] = await bodyAt(lab, "End");
  expect(high - low).toBeCloseTo(1 - 1 / 60, 2);
});

test("a path is drawn by a stroke: the body starts where it starts, and it is one edit", async ({ page }) => {
  const lab = await Lab.open(page);
  const group = await follow(lab, "drawn by hand");
  const before = await lab.readout();
  const pad = group.getByRole("img");
  await pad.scrollIntoViewIfNeeded();
  const box = await pad.boundingBox();
  if (!box) throw new Error("no pad");
  const at = (share: number) => {
    const angle = 2 * Math.PI * share;
    return [
      box.x + box.width * (0.5 + 0.3 * Math.cos(angle)),
      box.y + box.height * (0.5 + 0.3 * Math.sin(angle)),
    ];
  };
  await page.mouse.move(at(0)[0], at(0)[1]);
  await page.mouse.down();
  for (let i = 1; i <= 90; i++) await page.mouse.move(at(i / 100)[0], at(i / 100)[1]);
  await page.mouse.up();
  await expect(lab.status).toContainText("Path drawn through");
  const rows = group.locator("tbody tr");
  const points = await rows.count();
  expect(points).toBeGreaterThan(5);
  expect(points).toBeLessThanOrEqual(60);
  await lab.openGroup("True start");
  const x = Number(await lab.field("Position, x").inputValue());
  const last = Number(await lab.field(`Way point ${points}, x`).inputValue());
  expect(x).toBeGreaterThan(last);
  await page.getByRole("button", { name: /^Undo/ }).click();
  await expect.poll(() => lab.readout()).toBe(before);
});

test("without dragging: a press goes on with the path, way points are typed, the height too", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const group = await follow(lab, "drawn by hand");
  const rows = group.locator("tbody tr");
  const count = await rows.count();
  await group.getByRole("img").click({ position: { x: 60, y: 60 } });
  await expect(rows).toHaveCount(count + 1);
  await group.getByRole("button", { name: "Add a way point" }).click();
  await expect(rows).toHaveCount(count + 2);
  await lab.type(`Way point ${count + 2}, x`, "2.25");
  await lab.type("Height", "1.75");
  for (let row = 1; row <= count + 2; row++)
    await expect(lab.field(`Way point ${row}, z`)).toHaveValue("1.75");
  await group.getByRole("checkbox", { name: /Closed/ }).check();
  await group.getByRole("button", { name: `Remove way point ${count + 2}` }).click();
  await expect(rows).toHaveCount(count + 1);
  await expect(lab.alert).toBeEmpty();
});

test("way points on each other and no way point are refused in a sentence", async ({ page }) => {
  const lab = await Lab.open(page);
  const group = await follow(lab, "drawn by hand");
  const remove = group.getByRole("button", { name: "Remove way point 1", exact: true });
  while ((await group.locator("tbody tr").count()) > 1) await remove.click();
  await remove.click();
  await expect(lab.alert).toContainText("motion.path.points");
  await expect(group.locator("tbody tr")).toHaveCount(1);
  await group.getByRole("button", { name: "Add a way point" }).click();
  for (const axis of ["x", "y", "z"])
    await lab.type(`Way point 2, ${axis}`, await lab.field(`Way point 1, ${axis}`).inputValue());
  await expect(lab.alert).toContainText("apart");
});

test.describe("by touch", () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

  test("one finger draws on the pad and does not scroll the sheet", async ({ page }) => {
    const lab = await Lab.open(page);
    const group = await follow(lab, "drawn by hand");
    const pad = group.getByRole("img");
    await pad.scrollIntoViewIfNeeded();
    const box = await pad.boundingBox();
    if (!box) throw new Error("no pad");
    const client = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", x = 0, y = 0) =>
      client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
    await touch("touchStart", box.x + 40, box.y + 30);
    for (let i = 1; i <= 20; i++) await touch("touchMove", box.x + 40 + 8 * i, box.y + 30 + 6 * i);
    await touch("touchEnd");
    await expect(lab.status).toContainText("Path drawn through");
    expect((await pad.boundingBox())?.y).toBeCloseTo(box.y, 0);
  });
});
