import { expect, type Page, test } from "@playwright/test";
import { Lab } from "./lab";

const PLAIN = "./?renderer=canvas2d&theme=light";
const note = (page: Page) => page.getByRole("status").filter({ hasText: "Restored your last scene" });

test("the last scene comes back at the next visit, with a way back to the preset", async ({
  page,
  context,
}) => {
  const lab = await Lab.open(page);
  const fresh = await lab.readout();
  await expect(note(page)).toHaveCount(0);
  await lab.drag(2, 50, -30);
  await lab.type("Seed", "12");
  await expect(lab.status).toContainText("Seed set to 12");
  const readout = await lab.readout();
  await page.close();

  const again = await Lab.open(await context.newPage(), PLAIN);
  expect(await again.readout()).toBe(readout);
  await expect(note(again.page)).toBeVisible();
  await again.page.getByRole("button", { name: "Start fresh" }).click();
  await expect.poll(() => again.readout()).toBe(fresh);
  await expect(note(again.page)).toHaveCount(0);
  await again.page.keyboard.press("Control+z");
  await expect.poll(() => again.readout()).toBe(readout);
});

test("looking at a link without editing keeps the own scene", async ({ page, context }) => {
  const lab = await Lab.open(page);
  await lab.type("Seed", "21");
  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#v1\./);
  const link = PLAIN + new URL(page.url()).hash;
  await lab.type("Seed", "22");
  const visitor = await Lab.open(await context.newPage(), link);
  await expect(visitor.field("Seed")).toHaveValue("21");
  const next = await Lab.open(await context.newPage(), PLAIN);
  await expect(next.field("Seed")).toHaveValue("22");
});

test("two tabs leave each other alone; the one edited last is restored", async ({ page, context }) => {
  const one = await Lab.open(page);
  const two = await Lab.open(await context.newPage(), PLAIN);
  await one.type("Seed", "31");
  await two.type("Seed", "32");
  await one.type("Noise level σ", "0.02");
  await expect(one.status).toContainText("Noise level");
  await expect(two.field("Seed")).toHaveValue("32");
  await expect(one.field("Seed")).toHaveValue("31");
  const three = await Lab.open(await context.newPage(), PLAIN);
  await expect(three.field("Seed")).toHaveValue("31");
  await expect(three.field("Noise level σ")).toHaveValue("0.02");
  await expect.poll(() => new URL(two.page.url()).hash).toMatch(/^#v1\./);
  await two.page.reload();
  await expect(two.field("Seed")).toHaveValue("32");
});

for (const [what, text] of [
  ["cut in half", '{"version": 1, "name": "room", "dim'],
  ["of another shape", "[1, 2]"],
  ["of a newer version", '{"version": 99}'],
])
  test(`a kept scene ${what} is told and forgotten`, async ({ page }) => {
    await page.addInitScript((spoiled) => {
      if (!sessionStorage["spoiled"]) localStorage["rangelab.scene"] = spoiled;
      sessionStorage["spoiled"] = "yes";
    }, text);
    const lab = await Lab.open(page);
    await expect(lab.alert).toContainText("kept from your last visit");
    await expect(lab.alert).toContainText("default scene");
    expect((await lab.errors("uc-kf"))[0]).toMatch(/^[\d.]+$/);
    await page.reload();
    await expect(lab.status).toContainText("Ready");
    await expect(lab.alert).toBeEmpty();
  });

for (const [what, spoil] of [
  ["switched off", "get"],
  ["full", "setItem"],
] as const)
  test(`storage that is ${what} costs nothing but the memory`, async ({ page }) => {
    const errors: string[] = [];
    page.on("pageerror", (error) => errors.push(error.message));
    await page.addInitScript((part) => {
      const refuse = () => {
        throw new DOMException("refused", part === "get" ? "SecurityError" : "QuotaExceededError");
      };
      if (part === "get") Object.defineProperty(window, "localStorage", { get: refuse });
      else Storage.prototype.setItem = refuse;
    }, spoil);
    const lab = await Lab.open(page, "./?renderer=canvas2d");
    const before = await lab.readout();
    await lab.type("Seed", "41");
    await expect(lab.status).toContainText("Seed set to 41");
    await page.getByLabel("Theme").selectOption("dark");
    await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
    await page.keyboard.press("Control+z");
    await expect.poll(() => lab.readout()).toBe(before);
    expect(errors).toEqual([]);
  });
