import { expect, type Page, test } from "@playwright/test";
import { expectSentence, Health } from "./health";
import { Lab } from "./lab";
import { type Draft, goodLink, openChanged } from "./scenario-link";

const anchors = (change: (anchors: number[][], draft: Draft) => number[][]) => (draft: Draft) => {
  draft.anchors = change(draft.anchors, draft);
};

/** A good scene, and then the spoiled one as from a link that somebody sent. */
async function openSpoiled(page: Page, spoil: (draft: Draft) => void) {
  const health = new Health(page);
  const lab = await Lab.open(page);
  const good = await goodLink(lab);
  const before = await lab.readout();
  await openChanged(lab, good, spoil);
  return { health, lab, good, before };
}

test.describe("a geometry that says too little is estimated all the same", () => {
  const cases: [string, (draft: Draft) => void][] = [
    ["anchor on anchor", anchors(([first, , ...others]) => [first, [...first], ...others])],
    ["all anchors on one point", anchors((all) => all.map(() => [1, 1, 1]))],
    [
      "anchor on a sensor",
      anchors(([, ...others], { start, sensors }) => [
        start.position.map((value, axis) => value + sensors[0][axis]),
        ...others,
      ]),
    ],
    ["three anchors", anchors((all) => all.slice(0, 3))],
    ["one anchor", anchors((all) => all.slice(0, 1))],
    ["an anchor a million kilometres up", anchors(([[x, y], ...others]) => [[x, y, 1e9], ...others])],
    ["an anchor a million kilometres away", anchors(([, ...others]) => [[-1e9, 1e9, 1], ...others])],
    ["anchors in a line", anchors((all) => all.map((_, index) => [index, 1, 2]))],
    ["anchors in a plane", anchors((all) => all.map(([x, y]) => [x, y, 2]))],
    ["one sensor", (draft) => (draft.sensors = draft.sensors.slice(0, 1))],
    ["sensors in a line", (draft) => (draft.sensors = draft.sensors.map((_, i) => [0.1 * i - 0.2, 0, 0]))],
    ["sensors on one point", (draft) => (draft.sensors = draft.sensors.map(() => [0.1, 0, 0]))],
    ["noise of a thousand kilometres", (draft) => (draft.noise.sigma = 1e6)],
    ["noise below the width of an atom", (draft) => (draft.noise.sigma = 1e-12)],
    ["noise too small for numbers", (draft) => (draft.noise.sigma = 1e-300)],
    ["one step", (draft) => (draft.steps = 1)],
  ];
  for (const [what, spoil] of cases)
    test(what, async ({ page }) => {
      const { health, lab, good, before } = await openSpoiled(page, spoil);
      await expect(lab.status).toContainText("opened from the link");
      await expect(lab.alert).toBeEmpty();
      await expect(lab.status).toHaveText(/ends nearest|No estimator ran|\bis\b/);
      for (const key of ["Home", ".", "End"]) await page.keyboard.press(key);
      await health.expectGood(lab);
      await page.getByRole("button", { name: "Undo", exact: true }).click();
      await expect.poll(() => lab.readout()).toBe(before);
      await expect.poll(() => new URL(page.url()).hash).toBe(good);
      await health.expectGood(lab);
    });
});

test.describe("what cannot be a scenario is refused in a sentence with its numbers", () => {
  const cases: [string, (draft: Draft) => void, RegExp][] = [
    ["no noise", (draft) => (draft.noise.sigma = 0), /sigma.* 0/],
    ["noise of a billion metres and more", (draft) => (draft.noise.sigma = 1e10), /1e10|10000000000/],
    ["an anchor behind the moon", anchors(([, ...others]) => [[1e12, 0, 0], ...others]), /1e12/],
    ["no anchor", anchors(() => []), /anchors/],
    ["a point with two coordinates", anchors(([, ...others]) => [[1, 2], ...others]), /2/],
    ["no step", (draft) => (draft.steps = 0), /steps.* 0/],
    ["a million steps", (draft) => (draft.steps = 1_000_000), /1e6|1000000|1,000,000/],
  ];
  for (const [what, spoil, sentence] of cases)
    test(what, async ({ page }) => {
      const { health, lab, good, before } = await openSpoiled(page, spoil);
      await expectSentence(lab, sentence);
      expect(await lab.readout()).toBe(before);
      await expect.poll(() => new URL(page.url()).hash).toBe(good);
      await health.expectGood(lab);
      await lab.type("Seed", "32");
      await expect(lab.alert).toBeEmpty();
    });
});

test("what is typed as nonsense is not taken, by any field", async ({ page }) => {
  const health = new Health(page);
  const lab = await Lab.open(page);
  await lab.openGroups();
  const before = await lab.readout();
  const fields = page.locator('aside input[type="text"]');
  const count = await fields.count();
  expect(count).toBeGreaterThan(20);
  for (let index = 0; index < count; index++) {
    const field = fields.nth(index);
    const value = await field.inputValue();
    await field.fill("NaN");
    await field.press("Enter");
    await expect(field).toHaveAttribute("aria-invalid", "true");
    await field.press("Escape");
    await expect(field).toHaveValue(value);
  }
  expect(await lab.readout()).toBe(before);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  await health.expectGood(lab);
});

test("two hundred anchors, fifty sensors and a thousand steps leave the page usable", async ({ page }) => {
  test.setTimeout(180_000);
  const health = new Health(page);
  const lab = await Lab.open(page);
  const good = await goodLink(lab);
  const wave = (index: number, pace: number, size: number) =>
    Number((size * Math.sin(index * pace)).toFixed(1));
  await openChanged(lab, good, (draft) => {
    draft.anchors = Array.from({ length: 200 }, (_, i) => [wave(i, 1, 9), wave(i, 1.7, 9), wave(i, 2.3, 4)]);
    draft.sensors = Array.from({ length: 50 }, (_, i) => [wave(i, 1, 1), wave(i, 1.7, 1), wave(i, 2.3, 1)]);
    draft.steps = 1000;
  });
  await expect(lab.step).toHaveText("1000", { timeout: 60_000 });
  const start = Date.now();
  for (const key of ["Home", ".", ".", "End", ","]) await page.keyboard.press(key);
  await expect(lab.step).toHaveText("999");
  expect(Date.now() - start).toBeLessThan(20_000);
  await health.expectGood(lab);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expect(lab.step).not.toHaveText("999");
  await health.expectGood(lab);
});

test("a browser that stores nothing loses only the memory", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get: () => {
        throw new DOMException("The operation is insecure.", "SecurityError");
      },
    });
  });
  const health = new Health(page);
  const lab = await Lab.open(page);
  const hash = await goodLink(lab);
  await page.getByLabel("Theme").selectOption({ label: "Dark" });
  await health.expectGood(lab);
  await page.reload();
  await expect(lab.status).toContainText("Ready");
  expect(new URL(page.url()).hash).toBe(hash);
  await expect(lab.field("Seed")).toHaveValue("31");
  await health.expectGood(lab);
});

test("full storage is no reason to stop", async ({ page }) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("Exceeded the quota.", "QuotaExceededError");
    };
  });
  const health = new Health(page);
  const lab = await Lab.open(page);
  await goodLink(lab);
  await health.expectGood(lab);
});
