import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

const twin = (lab: Lab) => lab.page.locator("#scene-twin li").allInnerTexts();
const coordinates = async (lab: Lab, number: number) =>
  ((await lab.anchor(number)).match(/\((.*)\)/)?.[1].split(", ") ?? []).map((text) =>
    Number(text.replace("−", "-")),
  );
/** Where a pixel of the page is in the scene. */
const inScene = async (lab: Lab, x: number, y: number) => {
  const box = await lab.surface.boundingBox();
  return { x: (box?.x ?? 0) + x, y: (box?.y ?? 0) + y };
};
const middleOf = async (lab: Lab) => {
  const box = await lab.surface.boundingBox();
  return inScene(lab, (box?.width ?? 0) * 0.62, (box?.height ?? 0) * 0.75);
};

test("several things are chosen, dragged as one, and one undo takes all of them back", async ({ page }) => {
  const lab = await Lab.open(page);
  const before = await twin(lab);
  const [first, second] = [await lab.anchorPixel(2), await lab.anchorPixel(3)];
  await page.mouse.click(first.x, first.y);
  await page.keyboard.down("Control");
  await page.mouse.click(second.x, second.y);
  await page.keyboard.up("Control");
  await expect(page.getByRole("group", { name: "Selected anchor" })).toContainText("2 anchors");

  const old = [await coordinates(lab, 2), await coordinates(lab, 3)];
  await lab.drag(3, -50, 20);
  await expect(lab.status).toContainText("2 anchors moved");
  const now = [await coordinates(lab, 2), await coordinates(lab, 3)];
  const shift = [0, 1, 2].map((axis) => now[0][axis] - old[0][axis]);
  expect(Math.hypot(...shift)).toBeGreaterThan(0.2);
  shift.forEach((value, axis) => expect(now[1][axis] - old[1][axis]).toBeCloseTo(value, 6));
  await page.keyboard.press("Control+z");
  await expect
    .poll(async () => (await twin(lab)).map((text) => text.replace(", selected", "")))
    .toEqual(before);
});

test("a rectangle chooses, Ctrl A chooses all, keys move all of them", async ({ page }) => {
  const lab = await Lab.open(page);
  await page.getByRole("button", { name: "Select several" }).click();
  const [a, b] = [await lab.anchorPixel(2), await lab.anchorPixel(3)];
  await page.mouse.move(Math.max(a.x, b.x) + 20, Math.max(a.y, b.y) + 20);
  await page.mouse.down();
  await page.mouse.move(Math.min(a.x, b.x) - 20, Math.min(a.y, b.y) - 20, { steps: 4 });
  await expect(page.locator("svg.labels rect")).toBeVisible();
  await page.mouse.up();
  const chosen = (await twin(lab)).filter((text) => text.endsWith("selected"));
  expect(chosen.join()).toContain("Anchor 2 ");
  expect(chosen.join()).toContain("Anchor 3 ");
  await lab.surface.focus();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+a");
  await expect(lab.status).toContainText("6 anchors selected");
  const heights = await Promise.all([1, 4].map((number) => coordinates(lab, number)));
  await page.keyboard.press("PageUp");
  await expect(lab.status).toContainText("6 anchors moved");
  const lifted = await Promise.all([1, 4].map((number) => coordinates(lab, number)));
  lifted.forEach((point, i) => expect(point[2]).toBeCloseTo(heights[i][2] + 0.1, 6));
});

test("the typed middle of several moves them together", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.surface.focus();
  await page.keyboard.press("Control+a");
  const before = await coordinates(lab, 2);
  const card = page.getByRole("group", { name: "Selected anchor" });
  const x = card.getByRole("textbox", { name: "x" });
  const middle = Number((await x.inputValue()).replace("−", "-"));
  await x.fill(String(middle + 1));
  await x.press("Enter");
  await expect.poll(async () => (await coordinates(lab, 2))[0]).toBeCloseTo(before[0] + 1, 3);
});

test("without dragging: choose, press Move to, press the place", async ({ page }) => {
  const lab = await Lab.open(page);
  const at = await lab.anchorPixel(2);
  await page.mouse.click(at.x, at.y);
  const before = await coordinates(lab, 2);
  await page.getByRole("button", { name: "Move to…" }).click();
  await expect(lab.status).toContainText("Press where it shall go");
  await page.mouse.click(at.x - 80, at.y - 10);
  await expect(lab.status).toContainText("Anchor 2 moved to");
  const after = await coordinates(lab, 2);
  expect(after[2]).toBe(before[2]);
  const arrived = await lab.anchorPixel(2);
  expect(Math.hypot(arrived.x - at.x + 80, arrived.y - at.y + 10)).toBeLessThan(3);
});

test("a double click on the floor adds an anchor there, A where the pointer is, and D duplicates", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const count = (await twin(lab)).length;
  const place = await middleOf(lab);
  await page.mouse.dblclick(place.x, place.y);
  await expect(lab.status).toContainText(`Anchor ${count + 1} added at`);
  const added = await lab.anchorPixel(count + 1);
  expect(Math.hypot(added.x - place.x, added.y - place.y)).toBeLessThan(3);
  expect((await coordinates(lab, count + 1))[2]).toBe(0);

  await page.mouse.move(place.x + 60, place.y);
  await page.keyboard.press("a");
  await expect(lab.status).toContainText(`Anchor ${count + 2} added at`);
  const second = await lab.anchorPixel(count + 2);
  expect(Math.hypot(second.x - place.x - 60, second.y - place.y)).toBeLessThan(3);
  await page.keyboard.press("d");
  await expect(lab.status).toContainText("duplicated");
  expect(await twin(lab)).toHaveLength(count + 3);
});

test("Ctrl snaps a drag to the grid that is shown", async ({ page }) => {
  const lab = await Lab.open(page);
  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.keyboard.down("Control");
  await page.mouse.move(from.x - 45, from.y - 31, { steps: 5 });
  await page.mouse.up();
  await page.keyboard.up("Control");
  const [x, y] = await coordinates(lab, 2);
  expect([x % 0.5, y % 0.5].map(Math.abs)).toEqual([0, 0]);
});

test("Escape takes a drag back", async ({ page }) => {
  const lab = await Lab.open(page);
  const before = await lab.anchor(2);
  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x - 60, from.y, { steps: 4 });
  await expect.poll(() => lab.anchor(2)).not.toContain(before);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect.poll(() => lab.anchor(2)).toContain(before);
  await expect(page.getByRole("button", { name: /^Undo/ })).toBeDisabled();
});

test("the start of the body is dragged and its track follows", async ({ page }) => {
  const lab = await Lab.open(page);
  const start = page.getByText(/^Start of the body at/);
  const [before, readout] = [await start.innerText(), await lab.readout()];
  const at = await lab.pixelOf("start");
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 30, at.y + 40, { steps: 5 });
  await page.mouse.up();
  await expect(lab.status).toContainText("Start of the body moved to");
  expect(await start.innerText()).not.toBe(before);
  expect(await lab.readout()).not.toBe(readout);
});

test("an anchor set onto another one is kept, with a sentence", async ({ page }) => {
  const lab = await Lab.open(page);
  const [x, y, z] = await coordinates(lab, 3);
  const at = await lab.anchorPixel(2);
  await page.mouse.click(at.x, at.y);
  for (const [axis, value] of Object.entries({ x, y, z })) {
    const field = page.getByRole("group", { name: "Selected anchor" }).getByRole("textbox", { name: axis });
    await field.fill(String(value));
    await field.press("Enter");
  }
  await expect(lab.status).toContainText("onto anchor 3");
  expect(await lab.readout()).not.toMatch(/NaN/);
});

test("the wheel goes towards the pointer, and Fit brings everything back from anywhere", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const lab = await Lab.open(page);
  const home = await lab.anchorPixel(2);
  await page.mouse.move(home.x, home.y);
  const bar = page.locator(".scene .scale .bar");
  const metresPerPixel = async () =>
    parseFloat(await page.locator(".scene .scale").innerText()) / ((await bar.boundingBox())?.width ?? 0);
  const [far, apart] = [await metresPerPixel(), await lab.anchorPixel(5)];
  await page.mouse.wheel(0, -150);
  await expect.poll(metresPerPixel).toBeLessThan(0.9 * far);
  const [near, other] = [await lab.anchorPixel(2), await lab.anchorPixel(5)];
  const moved = Math.hypot(near.x - home.x, near.y - home.y);
  expect(moved).toBeLessThan(0.4 * Math.hypot(other.x - apart.x, other.y - apart.y));
  for (let i = 0; i < 40; i++) await page.mouse.wheel(0, 2000);
  const box = (await lab.surface.boundingBox())!;
  await page.mouse.move(box.x + box.width - 30, box.y + 200);
  for (let i = 0; i < 6; i++) {
    await page.mouse.down({ button: "right" });
    await page.mouse.move(box.x + 30, box.y + 300, { steps: 2 });
    await page.mouse.up({ button: "right" });
    await page.mouse.move(box.x + box.width - 30, box.y + 200);
  }
  await page.getByRole("button", { name: "Fit", exact: true }).click();
  await expect(async () => {
    for (const number of [1, 2, 3, 4, 5, 6]) {
      const { x, y } = await lab.anchorPixel(number);
      expect(x > box.x && x < box.x + box.width && y > box.y && y < box.y + box.height).toBe(true);
    }
  }).toPass();
});

test("preset views look along the axes; transitions take time unless less motion is wanted", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Top", exact: true }).click();
  const [one, two] = [await coordinates(lab, 1), await coordinates(lab, 2)];
  await expect(async () => {
    const [a, b] = [await lab.anchorPixel(1), await lab.anchorPixel(2)];
    expect(Math.sign(b.x - a.x)).toBe(Math.sign(two[0] - one[0]));
    expect(Math.abs(b.x - a.x)).toBeGreaterThan(100);
  }).toPass();
  await page.getByRole("button", { name: "Front", exact: true }).click();
  await expect(async () => {
    const [a, b] = [await lab.anchorPixel(1), await lab.anchorPixel(2)];
    expect(Math.sign(a.y - b.y)).toBe(Math.sign(two[2] - one[2]));
  }).toPass();

  await page.emulateMedia({ reducedMotion: "no-preference" });
  const frames = await page.evaluate(async () => {
    const label = () => document.querySelector('svg.labels text[data-id="0"]')?.getAttribute("data-x") ?? "";
    [...document.querySelectorAll("button")]
      .find((button) => button.textContent?.trim() === "Space")
      ?.click();
    const seen = new Set<string>();
    const until = performance.now() + 1200;
    while (performance.now() < until) {
      seen.add(label());
      await new Promise(requestAnimationFrame);
    }
    return seen.size;
  });
  expect(frames).toBeGreaterThan(3);
});

test("in the plane the view is from above and a drag beside the things moves it", async ({ page }) => {
  const lab = await Lab.open(page);
  await page.getByLabel("Preset").selectOption("planar");
  await expect(lab.status).toContainText("opened");
  await expect(page.getByRole("button", { name: "Top", exact: true })).toBeHidden();
  const before = [await lab.anchorPixel(1), await lab.anchorPixel(2)];
  const [one, two] = [await coordinates(lab, 1), await coordinates(lab, 2)];
  const scale = (before[1].x - before[0].x) / (two[0] - one[0]);
  expect(before[0].y - before[1].y).toBeCloseTo(scale * (two[1] - one[1]), 0);
  const place = await middleOf(lab);
  await page.mouse.move(place.x, place.y);
  await page.mouse.down();
  await page.mouse.move(place.x + 50, place.y - 30, { steps: 4 });
  await page.mouse.up();
  await expect(async () => {
    const after = await lab.anchorPixel(1);
    expect(after.x - before[0].x).toBeCloseTo(50, 0);
    expect(after.y - before[0].y).toBeCloseTo(-30, 0);
  }).toPass();
});

test("numbers never lie on each other, at any of the views", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const lab = await Lab.open(page);
  for (const view of ["Space", "Top", "Front", "Side", "Body"]) {
    await page.getByRole("button", { name: view, exact: true }).click();
    await page.waitForTimeout(300);
    const overlaps = await lab.page.evaluate(() => {
      const boxes = [...document.querySelectorAll("svg.labels text")].map((text) => ({
        name: text.textContent,
        box: text.getBoundingClientRect(),
      }));
      return boxes.flatMap((a, i) =>
        boxes.slice(i + 1).flatMap((b) => {
          const across = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
          const down = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
          return across > 2 && down > 6 ? [`${a.name} on ${b.name}`] : [];
        }),
      );
    });
    expect(overlaps, view).toEqual([]);
  }
});

test("the words of the scene follow what is drawn", async ({ page }) => {
  const lab = await Lab.open(page);
  const told = page.getByRole("list", { name: "More in the scene" });
  await expect(told).toContainText("UC-KF at (");
  await expect(told).toContainText("ranges are measured");
  const before = await told.innerText();
  await page.getByRole("button", { name: "Step back", exact: false }).first().click();
  await expect.poll(() => told.innerText()).not.toBe(before);
  await lab.type("Missing ranges", "40");
  await expect(told).toContainText(/\d+ of \d+ ranges are missing/);
  await expect(page.locator(".scene .note")).toContainText("missing at this step: dashed");
});
