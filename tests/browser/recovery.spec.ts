import { expect, type Page, test } from "@playwright/test";
import { Lab } from "./lab";

/** Keeps hold of the engine's memory, to break it from outside as a bug in it would from inside. */
async function holdMemory(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const memories: WebAssembly.Memory[] = [];
    const hold = (result: WebAssembly.Instance | WebAssembly.WebAssemblyInstantiatedSource) => {
      const { memory } = ("instance" in result ? result.instance : result).exports;
      if (memory instanceof WebAssembly.Memory) memories.push(memory);
      return result;
    };
    const instantiate = WebAssembly.instantiate as (...sources: unknown[]) => Promise<WebAssembly.Instance>;
    const wrapped = (...sources: unknown[]) => instantiate(...sources).then(hold);
    Object.assign(WebAssembly, { instantiate: wrapped });
    Object.assign(window, {
      breakEngine: () => {
        for (const memory of memories) new Uint8Array(memory.buffer).fill(255);
        return memories.length;
      },
    });
  });
}

const breakEngine = (page: Page) =>
  page.evaluate(() => (window as unknown as { breakEngine(): number }).breakEngine());

test("an engine that breaks is started again: the edit stays, the numbers are right, a report is offered", async ({
  page,
  context,
}) => {
  const other = await Lab.open(await context.newPage());
  await other.type("Seed", "31");
  await expect(other.status).toContainText("Seed set to 31");
  const expected = await other.readout();
  await other.page.evaluate(() => localStorage.clear());

  await holdMemory(page);
  const lab = await Lab.open(page);
  expect(await lab.readout()).not.toBe(expected);
  expect(await breakEngine(page)).toBeGreaterThan(0);
  await lab.type("Seed", "31");
  await expect(lab.alert).toContainText("Something unforeseen happened: The engine stopped");
  await expect.poll(() => lab.readout()).toBe(expected);
  await expect(page.getByRole("button", { name: "Undo" })).toHaveAttribute("title", /Seed set to 31/);
  await page.getByRole("button", { name: "Copy report" }).click();
  await expect(page.getByRole("button", { name: "Copied" })).toBeVisible();
  const report = await page.evaluate(() => navigator.clipboard.readText());
  for (const part of [/^rangelab \d/, /#v1\./, /RuntimeError/]) expect(report).toMatch(part);

  await page.getByRole("button", { name: "Dismiss" }).click();
  await lab.drag(2, 40, -20);
  await expect(lab.status).toContainText("Anchor 2 moved");
  await expect(lab.alert).toBeEmpty();
});

test("a page whose engine does not arrive says so in a sentence", async ({ page }) => {
  await page.route("**/rangelab_track_bg*.wasm", (route) => route.abort());
  await page.goto("./?renderer=canvas2d&theme=light");
  await expect(page.getByRole("alert")).toContainText("The page could not start");
  await expect(page.getByRole("button", { name: "Try again" })).toBeVisible();
  await page.unroute("**/rangelab_track_bg*.wasm");
  await page.getByRole("button", { name: "Try again" }).click();
  await expect(page.locator(".status")).toContainText("Ready");
});

test("a lab whose part of the engine does not arrive says so and leaves the last one; later it opens", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "31");
  const readout = await lab.readout();
  const explore = page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" });
  await page.route("**/rangelab_explore_bg*.wasm", (route) => route.abort());
  await explore.click();
  await expect(lab.alert).toContainText("The lab Explore could not be loaded");
  await expect(lab.alert).toContainText("The lab Track stays.");
  await expect(explore).not.toHaveAttribute("aria-current", "page");
  expect(await lab.readout()).toBe(readout);

  await page.unroute("**/rangelab_explore_bg*.wasm");
  await explore.click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await expect(lab.alert).toBeEmpty();
});

test("a page that opens in Explore shows its frame while the lab is loading", async ({ page, context }) => {
  const other = await Lab.open(await context.newPage());
  const labs = other.page.getByRole("navigation", { name: "Labs" });
  await labs.getByRole("button", { name: "Explore" }).click();
  await expect.poll(() => new URL(other.page.url()).hash).toMatch(/^#v1\./);
  const link = new URL(other.page.url()).hash;
  await other.page.evaluate(() => localStorage.clear());

  let arrive = (): void => undefined;
  const wait = new Promise<void>((resolve) => (arrive = resolve));
  await page.route("**/rangelab_explore_bg*.wasm", (route) => wait.then(() => route.continue()));
  await page.goto(`./?renderer=canvas2d&theme=light${link}`);
  await expect(page.getByText("Loading the lab Explore…")).toBeVisible();
  await expect(page.getByRole("button", { name: "Explore" })).toHaveAttribute("aria-current", "page");
  arrive();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await expect(page.getByText("Loading the lab")).toHaveCount(0);
  await expect(page.getByRole("alert")).toBeEmpty();
});

test("a page that cannot be drawn keeps the scene and offers ways back", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "31");
  await expect(lab.status).toContainText("Seed set to 31");
  const readout = await lab.readout();
  await page.evaluate(() => {
    const original = Number.prototype.toPrecision;
    Number.prototype.toPrecision = () => {
      throw new Error("Numbers cannot be written any more.");
    };
    Object.assign(window, { mend: () => (Number.prototype.toPrecision = original) });
  });
  await page.getByRole("button", { name: "One step back" }).click();
  await expect(page.getByRole("heading", { name: "The page could not be drawn" })).toBeVisible();
  await expect(page.getByRole("alert")).toContainText("Numbers cannot be written any more.");
  await page.getByRole("button", { name: "Copy report" }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(/#v1\./);

  await page.evaluate(() => (window as unknown as { mend(): void }).mend());
  await page.getByRole("button", { name: "Draw it again" }).click();
  await expect(lab.field("Seed")).toHaveValue("31");
  await page.keyboard.press("End");
  await expect.poll(() => lab.readout()).toBe(readout);
  await page.keyboard.press("Control+z");
  await expect(lab.field("Seed")).toHaveValue("1");
});
