import { expect, test } from "@playwright/test";
import { Lab } from "./lab";
import { pack, unpack } from "./scenario-link";

const PLAIN = "./?renderer=canvas2d&theme=light";
async function changedLink(lab: Lab): Promise<string> {
  await lab.drag(2, 50, -20);
  await lab.type("Seed", "31");
  await expect(lab.status).toContainText("Seed set to 31");
  await expect.poll(() => new URL(lab.page.url()).hash).toMatch(/^#v1\./);
  await expect.poll(() => unpack(new URL(lab.page.url()).hash).seed).toBe(31);
  return new URL(lab.page.url()).hash;
}

test("a shared link opens the same scenario with the same numbers", async ({ page, context }) => {
  const lab = await Lab.open(page);
  const hash = await changedLink(lab);
  await page.getByRole("button", { name: "Share" }).click();
  await expect(lab.status).toContainText("Link copied");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain(hash);
  const other = await Lab.open(await context.newPage(), PLAIN + hash);
  expect(await other.readout()).toBe(await lab.readout());
  expect(await other.anchor(2)).toBe((await lab.anchor(2)).replace(", selected", ""));
  await expect(other.alert).toBeEmpty();
});

test("a link pasted into the open page is an edit that can be undone", async ({ page }) => {
  const lab = await Lab.open(page);
  const before = await lab.readout();
  const hash = await changedLink(lab);
  const after = await lab.readout();
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect.poll(() => lab.readout()).toBe(before);
  await expect.poll(() => new URL(page.url()).hash).not.toBe(hash);
  await page.evaluate((next) => (location.hash = next), hash);
  await expect.poll(() => lab.readout()).toBe(after);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => lab.readout()).toBe(before);
});

test("a link that arrives during a drag opens when the drag ends; each is an edit of its own", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const [start, hash] = [await lab.anchor(2), await changedLink(lab)];
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect.poll(() => lab.anchor(2)).toBe(start);
  // The address follows an edit a moment later; before that, the link would be no change of it.
  await expect.poll(() => new URL(page.url()).hash).not.toBe(hash);
  const from = await lab.anchorPixel(3);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 40, from.y - 20, { steps: 4 });
  await page.evaluate((next) => (location.hash = next), hash);
  await page.mouse.move(from.x + 50, from.y - 20, { steps: 4 });
  await expect(lab.field("Seed")).not.toHaveValue("31");
  await page.mouse.up();
  await expect(lab.field("Seed")).toHaveValue("31");
  const undo = page.getByRole("button", { name: "Undo" });
  await expect(undo).toHaveAttribute("title", /opened from the link/);
  await undo.click();
  await expect(undo).toHaveAttribute("title", /Anchor 3 moved/);
});

test("a bad link pasted into the open page says so and leaves scene, history and address alone", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const good = await changedLink(lab);
  const readout = await lab.readout();
  await page.evaluate((half) => (location.hash = half), good.slice(0, good.length / 2));
  await expect(lab.alert).toContainText(/damaged|cut off/);
  await expect(lab.alert).toContainText("stays as it was");
  expect(await lab.readout()).toBe(readout);
  await expect.poll(() => new URL(page.url()).hash).toBe(good);
  await expect(page.getByRole("button", { name: "Undo" })).toHaveAttribute("title", /Seed set to 31/);
});

test.describe("bad links say so and open the last scene, without one the default", () => {
  const cases: [string, (good: string) => string, RegExp][] = [
    ["cut in half", (good) => good.slice(0, good.length / 2), /damaged|cut off/],
    ["of another kind", () => "#hello", /form #v1/],
    ["of a newer version", (good) => good.replace("#v1.", "#v7."), /version 7/],
    ["too long", () => `#v1.${"A".repeat(10_000)}`, /characters long/],
    ["a bomb", () => pack({ name: "x".repeat(100_000) }), /unpacks to more/],
    ["no scenario", () => pack([1, 2, 3]), /./],
    ["noise 0", (good) => pack({ ...unpack(good), noise: { kind: "range", sigma: 0 } }), /sigma/],
    ["an unknown field", (good) => pack({ ...unpack(good), colour: "red" }), /colour/],
  ];
  for (const [what, spoil, sentence] of cases) {
    test(what, async ({ page, context }) => {
      const lab = await Lab.open(page);
      const before = await lab.readout();
      const good = await changedLink(lab);
      const after = await lab.readout();
      for (const [shown, readout] of [
        ["last scene", after],
        ["default scene", before],
      ]) {
        const other = await Lab.open(await context.newPage(), PLAIN + spoil(good));
        await expect(other.alert).toContainText(sentence);
        await expect(other.alert).toContainText(shown);
        expect(await other.readout()).toBe(readout);
        await expect.poll(() => new URL(other.page.url()).hash).not.toBe(spoil(good));
        await page.evaluate(() => localStorage.clear());
      }
    });
  }
});
