import { type CDPSession, expect, type Page, test } from "@playwright/test";
import { Lab } from "./lab";

test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

interface Spot {
  x: number;
  y: number;
}

/** Fingers on the glass, moved together from their first places to their last in a few steps. */
class Fingers {
  readonly #client: CDPSession;

  constructor(client: CDPSession) {
    this.#client = client;
  }

  static async on(page: Page): Promise<Fingers> {
    return new Fingers(await page.context().newCDPSession(page));
  }

  async slide(paths: readonly { from: Spot; to: Spot }[]): Promise<void> {
    const steps = 6;
    await this.#touch(
      "touchStart",
      paths.map(({ from }) => from),
    );
    for (let i = 1; i <= steps; i++)
      await this.#touch(
        "touchMove",
        paths.map(({ from, to }) => ({
          x: from.x + ((to.x - from.x) * i) / steps,
          y: from.y + ((to.y - from.y) * i) / steps,
        })),
      );
    await this.#touch("touchEnd", []);
  }

  async tap(at: Spot): Promise<void> {
    await this.#touch("touchStart", [at]);
    await this.#touch("touchEnd", []);
  }

  #touch(type: "touchStart" | "touchMove" | "touchEnd", spots: readonly Spot[]): Promise<unknown> {
    const touchPoints = spots.map(({ x, y }, id) => ({ x, y, id }));
    return this.#client.send("Input.dispatchTouchEvent", { type, touchPoints });
  }
}

const between = (a: Spot, b: Spot) => Math.hypot(a.x - b.x, a.y - b.y);

test("two fingers stretch, move and turn the scene and leave the anchors where they are", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const fingers = await Fingers.on(page);
  const twin = await page.locator("#scene-twin").innerText();
  const box = (await lab.surface.boundingBox())!;
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const aside = (dx: number, dy: number) => ({ x: middle.x + dx, y: middle.y + dy });
  const places = async () => [await lab.anchorPixel(5), await lab.anchorPixel(6)] as const;

  const start = await places();
  await fingers.slide([
    { from: aside(-40, 60), to: aside(-58, 60) },
    { from: aside(40, 60), to: aside(58, 60) },
  ]);
  await expect.poll(async () => between(...(await places()))).toBeGreaterThan(1.2 * between(...start));

  await page.getByRole("button", { name: "Fit", exact: true }).click();
  await expect.poll(async () => between(...(await places()))).toBeLessThan(1.1 * between(...start));
  await page.waitForTimeout(400);
  const home = await places();
  await fingers.slide([
    { from: aside(-40, 60), to: aside(-40, 90) },
    { from: aside(40, 60), to: aside(40, 90) },
  ]);
  await expect(async () => {
    const [five, six] = await places();
    // Perspective: what lies nearer than the middle moves farther.
    for (const [now, old] of [
      [five, home[0]],
      [six, home[1]],
    ]) {
      expect(now.y - old.y).toBeGreaterThan(20);
      expect(now.y - old.y).toBeLessThan(45);
      expect(Math.abs(now.x - old.x)).toBeLessThan(6);
    }
  }).toPass();

  const before = await places();
  await fingers.slide([
    { from: aside(-50, 60), to: aside(-40, 30) },
    { from: aside(50, 60), to: aside(40, 90) },
  ]);
  const angle = ([a, b]: readonly [Spot, Spot]) => Math.atan2(b.y - a.y, b.x - a.x);
  await expect.poll(async () => Math.abs(angle(await places()) - angle(before))).toBeGreaterThan(0.1);
  expect(await page.locator("#scene-twin").innerText()).toBe(twin);
});

test("one finger drags an anchor as one edit, beside the things it turns the scene", async ({ page }) => {
  const lab = await Lab.open(page);
  const fingers = await Fingers.on(page);
  const before = await lab.anchor(2);
  const from = await lab.anchorPixel(2);
  await fingers.slide([{ from, to: { x: from.x - 40, y: from.y - 10 } }]);
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await page.keyboard.press("Control+z");
  await expect.poll(() => lab.anchor(2)).toContain(before);

  const box = (await lab.surface.boundingBox())!;
  const place = { x: box.x + 30, y: box.y + 0.55 * box.height };
  const old = await lab.anchorPixel(3);
  await fingers.slide([{ from: place, to: { x: place.x + 60, y: place.y } }]);
  await expect.poll(async () => between(await lab.anchorPixel(3), old)).toBeGreaterThan(10);
  expect(await lab.anchor(2)).toContain(before);
});

test("a finger draws a wall, and taps draw a box", async ({ page }) => {
  const lab = await Lab.open(page);
  const fingers = await Fingers.on(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  const start = await lab.pixelOf("start");
  const at = (dx: number, dy: number) => ({ x: start.x + dx, y: start.y + dy });
  await page.getByRole("button", { name: "Draw…" }).click();
  await page.getByRole("button", { name: "Draw a wall" }).click();
  await fingers.slide([{ from: at(-30, 40), to: at(40, 60) }]);
  await expect(lab.status).toContainText("Wall 1 drawn from");
  await page.getByRole("button", { name: "Draw…" }).click();
  await page.getByRole("button", { name: "Draw a keep-out box" }).click();
  await fingers.tap(at(-30, 20));
  await expect(lab.status).toContainText("Press where it ends");
  await fingers.tap(at(30, 50));
  await expect(lab.status).toContainText("Keep out 1 drawn from");
});

test("taps choose several, send them to a place, and a double tap adds an anchor", async ({ page }) => {
  const lab = await Lab.open(page);
  const fingers = await Fingers.on(page);
  await page.getByRole("button", { name: "Select several" }).tap();
  await fingers.tap(await lab.anchorPixel(2));
  await fingers.tap(await lab.anchorPixel(6));
  const card = page.getByRole("group", { name: "Selected anchor" });
  await expect(card).toContainText("2 anchors");
  const [two, six] = [await lab.anchor(2), await lab.anchor(6)];
  await card.getByRole("button", { name: "Move to…" }).tap();
  const box = (await lab.surface.boundingBox())!;
  await fingers.tap({ x: box.x + box.width / 2, y: box.y + 0.45 * box.height });
  await expect(lab.status).toContainText("2 anchors moved");
  expect(await lab.anchor(2)).not.toBe(two);
  expect(await lab.anchor(6)).not.toBe(six);

  await lab.surface.press("Escape");
  const count = await page.locator("#scene-twin li").count();
  const floor = { x: box.x + 0.3 * box.width, y: box.y + 0.6 * box.height };
  await fingers.tap(floor);
  await fingers.tap(floor);
  await expect(page.locator("#scene-twin li")).toHaveCount(count + 1);
});

test("a page that is scrolled over a plot keeps its noise; a tap and a finger that goes sideways set it", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Localize" }).click();
  const marker = lab.plot("Position RMSE").locator(".now");
  await marker.scrollIntoViewIfNeeded();
  const undo = page.getByRole("button", { name: "Undo" });
  const [fingers, start] = [await Fingers.on(page), await undo.getAttribute("title")];
  const spot = async (): Promise<Spot> => {
    const box = (await lab.plot("Position RMSE").locator(".host").boundingBox())!;
    return { x: box.x + 0.3 * box.width, y: box.y + 0.5 * box.height };
  };
  const scrolled = () => page.evaluate(() => scrollY);

  const [from, before] = [await spot(), await scrolled()];
  await fingers.slide([{ from, to: { x: from.x, y: from.y - 150 } }]);
  await expect.poll(scrolled).toBeGreaterThan(before + 50);
  await lab.settled();
  expect(await undo.getAttribute("title")).toBe(start);

  await fingers.tap(await spot());
  await expect(undo).toHaveAttribute("title", /ζ set to/);
  const tapped = await undo.getAttribute("title");
  const again = await spot();
  await fingers.slide([{ from: again, to: { x: again.x + 90, y: again.y } }]);
  await expect(undo).not.toHaveAttribute("title", tapped!);
});
