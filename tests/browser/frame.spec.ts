import { expect, type Page, test } from "@playwright/test";
import { Lab } from "./lab";

const bar = (page: Page, name: string) => page.getByRole("separator", { name });
const panel = (page: Page) => page.getByRole("complementary", { name: "Controls" });

async function width(page: Page): Promise<number> {
  return (await panel(page).boundingBox())?.width ?? 0;
}

/** Parts of the page that stand beside each other and must not overlap. */
async function boxes(page: Page): Promise<{ part: string; box: DOMRect }[]> {
  return page.evaluate(() =>
    ["header", ".view", ".timeline", ".status", "#plots", "aside"].flatMap((part) => {
      const box = document.querySelector(part)?.getBoundingClientRect();
      return box && box.width > 0 && box.height > 0 ? [{ part, box: box.toJSON() as DOMRect }] : [];
    }),
  );
}

test("a bar makes the panel larger by pointer, key and double click, and is remembered", async ({
  page,
  context,
}) => {
  await Lab.open(page);
  const splitter = bar(page, "Width of the controls");
  const [designed, at] = [await width(page), await splitter.boundingBox()];
  if (!at) throw new Error("no bar");
  await page.mouse.move(at.x + 4, at.y + 300);
  await page.mouse.down();
  await page.mouse.move(at.x - 96, at.y + 300, { steps: 5 });
  await page.mouse.up();
  await expect.poll(() => width(page)).toBeCloseTo(designed + 100, -1);
  await expect(splitter).toHaveAttribute("aria-valuenow", String(Math.round(await width(page))));
  await splitter.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => width(page)).toBeCloseTo(designed + 68, -1);
  await splitter.evaluate((element) => {
    for (const key of ["ArrowLeft", "ArrowLeft", "ArrowRight", "ArrowLeft"])
      element.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  });
  await expect.poll(() => width(page), "keys faster than a frame").toBeCloseTo(designed + 100, -1);

  const other = await context.newPage();
  await Lab.open(other);
  expect(await width(other)).toBe(await width(page));
  await bar(other, "Width of the controls").dblclick();
  await expect.poll(() => width(other)).toBe(designed);
});

test("panel and plots are put away and come back, by bar and by button", async ({ page }) => {
  const lab = await Lab.open(page);
  const scene = async () => (await lab.scene.boundingBox()) ?? { width: 0, height: 0 };
  const before = await scene();
  await bar(page, "Width of the controls").focus();
  await page.keyboard.press("Enter");
  await expect(lab.field("Seed")).toHaveCount(0);
  expect((await scene()).width).toBeGreaterThan(before.width + 200);
  await page.getByRole("button", { name: "Show plots" }).click();
  await expect(page.locator(".plots")).toHaveCount(0);
  expect((await scene()).height).toBeGreaterThan(before.height + 100);
  await page.reload();
  await expect(lab.status).toContainText("Ready");
  await expect(page.locator(".plots")).toHaveCount(0);
  await page.getByRole("button", { name: "Show plots" }).click();
  await page.getByRole("button", { name: "Show panel" }).click();
  await expect(page.locator(".plots")).toBeVisible();
  expect(await scene()).toEqual(before);
});

test("nothing overlaps or leaves the window, however it is sized", async ({ page }) => {
  test.setTimeout(120_000);
  await Lab.open(page);
  for (const pane of ["Width of the controls", "Height of the plots"]) {
    await bar(page, pane).focus();
    await page.keyboard.press("End");
  }
  for (const [wide, high] of [
    [1920, 1080],
    [1440, 900],
    [1024, 768],
    [820, 600],
    [720, 500],
    [844, 390],
    [390, 844],
    [320, 568],
  ]) {
    await page.setViewportSize({ width: wide, height: high });
    await page.waitForTimeout(200);
    const all = await boxes(page);
    for (const { part, box } of all) {
      expect(box.right, `${part} at ${wide} x ${high}`).toBeLessThanOrEqual(wide + 0.5);
      if (wide > 700 && high > 480)
        expect(box.bottom, `${part} at ${wide} x ${high}`).toBeLessThanOrEqual(high + 0.5);
    }
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(wide);
    const shown = all.filter(({ part }) => part !== "aside" || (wide > 700 && high > 480));
    for (const [i, a] of shown.entries())
      for (const b of shown.slice(i + 1)) {
        const across = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        const down = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        expect(Math.min(across, down), `${a.part} on ${b.part} at ${wide} x ${high}`).toBeLessThanOrEqual(
          0.5,
        );
      }
  }
});

test("on a narrow screen the controls are a sheet: button, handle, focus, Escape", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const lab = await Lab.open(page);
  const toggle = page.getByRole("button", { name: "Controls", exact: true });
  await expect(lab.field("Seed")).toBeHidden();
  await toggle.click();
  await expect(lab.field("Seed")).toBeVisible();
  await expect(page.getByRole("group", { name: "Settings" })).toBeFocused();
  await expect(lab.scene).toBeInViewport();
  const handle = bar(page, "Height of the controls");
  const before = (await panel(page).boundingBox())?.height ?? 0;
  await handle.focus();
  await page.keyboard.press("Shift+ArrowUp");
  await expect.poll(async () => (await panel(page).boundingBox())?.height).toBeGreaterThan(before + 50);
  await page.keyboard.press("Escape");
  await expect(lab.field("Seed")).toBeHidden();
  await expect(toggle).toBeFocused();

  await toggle.click();
  await page.waitForTimeout(300);
  const at = await handle.boundingBox();
  if (!at) throw new Error("no handle");
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + at.width / 2, 820, { steps: 6 });
  await page.mouse.up();
  await expect(lab.field("Seed")).toBeHidden();
});

test("the scenario goes out as a file and comes back from one, chosen or dropped", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "55");
  await expect(lab.status).toContainText("Seed set to 55");
  const readout = await lab.readout();
  await page.getByRole("button", { name: "Export" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Scenario as a file" }).click();
  const file = await download;
  expect(file.suggestedFilename()).toMatch(/\.json$/);
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect.poll(() => lab.readout()).not.toBe(readout);

  await page.getByLabel("Scenario file").setInputFiles(await file.path());
  await expect(lab.status).toContainText("Scenario opened from the file");
  await expect.poll(() => lab.readout()).toBe(readout);
  await page.keyboard.press("Control+z");
  await expect.poll(() => lab.readout()).not.toBe(readout);

  const drop = (text: string) =>
    page.evaluate((contents) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([contents], "dropped.json"));
      window.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }, text);
  await drop("no JSON at all");
  await expect(lab.alert).toContainText("dropped.json is no JSON document");
  await drop('{"version": 1}');
  await expect(lab.alert).toContainText("dropped.json");
  await drop((await (await file.createReadStream()).toArray()).join(""));
  await expect(lab.status).toContainText("opened from the file dropped.json");
  await expect.poll(() => lab.readout()).toBe(readout);
  await expect(lab.alert).toBeEmpty();
});

test("the theme follows the system until one is chosen, and the choice is remembered", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await Lab.open(page, "./?renderer=canvas2d");
  const html = page.locator("html");
  await expect(html).toHaveAttribute("data-theme", "dark");
  await page.emulateMedia({ colorScheme: "light" });
  await expect(html).toHaveAttribute("data-theme", "light");
  await page.getByLabel("Theme").selectOption("projector");
  await expect(html).toHaveAttribute("data-theme", "projector");
  await page.reload();
  await expect(html).toHaveAttribute("data-theme", "projector");
  const surface = await page.evaluate(() =>
    getComputedStyle(document.documentElement).getPropertyValue("--surface"),
  );
  await expect(page.locator("meta[name=theme-color]")).toHaveAttribute("content", surface.trim());
});

test("title, help and reduced motion", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const lab = await Lab.open(page);
  await expect(page).toHaveTitle("A room – Track – rangelab");
  await lab.surface.focus();
  await page.keyboard.press("?");
  await expect(page.getByRole("dialog", { name: "Keys and gestures" })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toHaveCount(0);
  await expect(lab.surface).toBeFocused();
  const moving = await page.evaluate(() =>
    [...document.querySelectorAll("*")]
      .filter((element) => /[1-9]/.test(getComputedStyle(element).transitionDuration))
      .map((element) => element.outerHTML.slice(0, 80)),
  );
  expect(moving).toEqual([]);
});

test("an error nobody foresaw is told, reported, and leaves page and scene alive", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "8");
  await page.evaluate(() => setTimeout(() => (null as unknown as { x: number }).x));
  await expect(lab.alert).toContainText("Something unforeseen happened");
  await page.getByRole("button", { name: "Copy report" }).click();
  await expect(page.getByRole("button", { name: "Copied" })).toBeVisible();
  const report = await page.evaluate(() => navigator.clipboard.readText());
  for (const part of [/^rangelab \d/, /#v1\./, /Chrom/, /TypeError/]) expect(report).toMatch(part);
  await page.getByRole("button", { name: "Dismiss" }).click();
  await lab.type("Seed", "9");
  await expect(lab.status).toContainText("Seed set to 9");
  await expect(lab.alert).toBeEmpty();
});
