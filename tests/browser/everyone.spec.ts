import { expect, type Page, test } from "@playwright/test";
import { Health } from "./health";
import { Lab } from "./lab";
import { SIZES, THEMES } from "./states";

const SMALLEST = 24;

/** What can be pressed and is smaller than a finger or a shaking hand needs, itself and its label. */
function small(page: Page): Promise<string[]> {
  return page.evaluate((least) => {
    const found: string[] = [];
    const pressed = "button, input, select, summary, a[href], [role=slider], [role=separator], [role=tab]";
    for (const element of document.querySelectorAll<HTMLElement>(pressed)) {
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      if (element.closest(".visually-hidden, .u-legend")) continue;
      // A thin bar is pressed beside it, too: on what it lays over its neighbours.
      const beside = getComputedStyle(element, "::after");
      const parts = [element, ...((element as HTMLInputElement).labels ?? [])].map((part) =>
        part.getBoundingClientRect(),
      );
      const reach = { width: parseFloat(beside.width) || 0, height: parseFloat(beside.height) || 0 };
      const large = [...parts, reach].some(
        ({ width, height }) => width >= least - 0.5 && height >= least - 0.5,
      );
      const { width, height } = parts[0];
      if (!large && width > 0)
        found.push(
          `${element.tagName} ${element.ariaLabel ?? element.textContent?.trim()}: ${width.toFixed()} x ${height.toFixed()}`,
        );
    }
    return found;
  }, SMALLEST);
}

/** Pixels by which the page is wider than the window. */
const tooWide = (page: Page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

for (const size of SIZES)
  test(`everything that is pressed is at least ${SMALLEST} px, ${size.width} x ${size.height}`, async ({
    page,
  }) => {
    await page.setViewportSize(size);
    const lab = await Lab.open(page);
    await lab.choose(2);
    await lab.openGroups();
    for (const theme of THEMES) {
      await page.evaluate((name) => (document.documentElement.dataset["theme"] = name), theme);
      expect(await small(page), theme).toEqual([]);
    }
  });

// Zooming in makes the window smaller in the page's pixels: 1280 px at 200 % are 640, at 400 % 320.
for (const [zoom, width, height] of [
  [200, 640, 400],
  [400, 320, 256],
])
  test(`zoomed to ${zoom} % nothing is cut off at the side`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    const health = new Health(page);
    const lab = await Lab.open(page);
    expect(await tooWide(page)).toBeLessThanOrEqual(0);
    await lab.openGroups();
    expect(await tooWide(page)).toBeLessThanOrEqual(0);
    await expect(lab.field("Seed")).toBeVisible();
    expect(health.errors).toEqual([]);
  });

test("wider text spacing cuts nothing off", async ({ page }) => {
  const lab = await Lab.open(page);
  await page.addStyleTag({
    content:
      "* { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important }",
  });
  await lab.openGroups();
  expect(await tooWide(page)).toBeLessThanOrEqual(0);
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, .status, header label")]
      .filter((part) => part.checkVisibility() && part.scrollWidth > part.clientWidth + 2)
      .filter((part) => getComputedStyle(part).overflowX === "hidden")
      .map((part) => part.textContent?.trim()),
  );
  expect(cut).toEqual([]);
});

test("with forced colours buttons keep their edges and focus its frame", async ({ page }) => {
  await page.emulateMedia({ forcedColors: "active" });
  const lab = await Lab.open(page);
  const edges = await page
    .locator("header button:visible, .timeline button:visible")
    .evaluateAll((buttons) => buttons.map((button) => getComputedStyle(button).borderTopStyle));
  expect(edges.length).toBeGreaterThan(5);
  expect(new Set(edges)).toEqual(new Set(["solid"]));
  await page.keyboard.press("Tab");
  expect(await page.evaluate(() => getComputedStyle(document.activeElement!).outlineStyle)).toBe("solid");
  await expect(lab.surface).toBeVisible();
});

test("with reduced motion nothing moves by itself", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await Lab.open(page);
  const moving = await page.evaluate(() =>
    [...document.querySelectorAll("*")]
      .filter((element) => {
        const style = getComputedStyle(element);
        const seconds = [style.transitionDuration, style.animationDuration].flatMap((text) =>
          text.split(","),
        );
        return seconds.some((duration) => parseFloat(duration) > 0.01);
      })
      .map((element) => `${element.tagName}.${element.className}`),
  );
  expect(moving).toEqual([]);
  expect(await page.evaluate(() => document.getAnimations().length)).toBe(0);
});

test("what changed is said in a sentence with its numbers", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.surface.focus();
  await page.keyboard.press("2");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Escape");
  await lab.type("Seed", "5");
  await expect(page.locator('[aria-live="polite"]')).toHaveText(/^Seed set to 5\. .*\d.*\.$/);
});
