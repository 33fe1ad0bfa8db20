import { execFileSync } from "node:child_process";
import { expect, type Page, test } from "@playwright/test";
import { violations, wear } from "./axe";
import { Health } from "./health";
import { Lab } from "./lab";
import { unpack } from "./scenario-link";

const ROOT = new URL("../..", import.meta.url).pathname;

/** The Localize lab, reached from Track as a visitor does. */
async function openLocalize(page: Page, preset?: string): Promise<Lab> {
  const lab = await Lab.open(page);
  if (preset) await lab.openPreset(preset);
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Localize" }).click();
  await expect(errors(page)).toBeVisible();
  return lab;
}

const errors = (page: Page) => page.getByRole("table", { name: "Errors of the localizers" });

/** Orientation in degrees, position in metres, mirrored, iterations. */
function read(page: Page, localizer: string): Promise<string[]> {
  return errors(page).locator(`[data-localizer="${localizer}"] td`).allInnerTexts();
}

const trials = async (page: Page): Promise<number> =>
  Number.parseInt(await page.getByTestId("trials").innerText(), 10);

/** The numbers behind a plot, as its table tells them: the head, then a row a point. */
async function table(lab: Lab, title: string): Promise<string[][]> {
  await lab.plotMenu(title, "Data table");
  const dialog = lab.page.getByRole("dialog");
  const rows = await dialog
    .locator("table tr")
    .evaluateAll((all) =>
      all.map((row) => [...(row as HTMLTableRowElement).cells].map((cell) => cell.innerText.trim())),
    );
  await lab.page.keyboard.press("Escape");
  return rows;
}

test("dragging an anchor moves numbers and clouds; one undo takes it back", async ({ page }) => {
  const lab = await openLocalize(page);
  const before = await errors(page).innerText();
  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const picture = await lab.middle();
  await page.mouse.move(from.x - 90, from.y + 40, { steps: 6 });
  await expect.poll(() => errors(page).innerText()).not.toBe(before);
  await expect.poll(async () => (await lab.middle()).equals(picture)).toBe(false);
  await page.mouse.up();
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await page.keyboard.press("Control+z");
  await expect.poll(() => errors(page).innerText()).toBe(before);
});

test("the trial drawn has the errors that the command line prints", async ({ page }) => {
  test.setTimeout(600_000);
  const lab = await openLocalize(page, "localization-paper");
  await page.getByRole("button", { name: "Trial 0" }).click();
  await lab.type("Trial drawn", "7");
  await expect(page.getByRole("button", { name: "Trial 7" })).toBeVisible();
  const options = ["localize", "localization-paper", "--trial", "7", "--format", "json"];
  const text = execFileSync("cargo", ["run", "--quiet", "--bin", "rangelab", "--", ...options], {
    cwd: ROOT,
    encoding: "utf8",
  });
  const { estimators } = JSON.parse(text) as {
    estimators: {
      name: string;
      iterations: number;
      errors: { angle: number; position: number } | null;
    }[];
  };
  expect(estimators).toHaveLength(10);
  for (const { name, errors: expected, iterations } of estimators) {
    const [angle, position, , count] = await read(page, name);
    expect(Number(count), name).toBe(iterations);
    if (!expected) expect([angle, position], name).toEqual(["–", "–"]);
    else {
      expect(Number(angle) / ((expected.angle * 180) / Math.PI), name).toBeCloseTo(1, 2);
      expect(Number(position) / expected.position, name).toBeCloseTo(1, 2);
    }
  }
});

test("over O(3) much noise mirrors bodies, over SO(3) never those of OUC-LS", async ({ page }) => {
  const lab = await openLocalize(page, "localization-paper");
  await lab.type("Signal to noise ζ", "20");
  await expect.poll(async () => Number((await read(page, "ouc-ls"))[0])).toBeGreaterThan(30);
  expect((await read(page, "ouc-ls"))[2]).toBe("0");
  const proper = await lab.surface.screenshot();
  await lab.pick("Group", "O(D)");
  await expect.poll(async () => Number((await read(page, "ouc-ls"))[2])).toBeGreaterThan(10);
  await expect(lab.status).toContainText("mirror the body in");
  await expect(page.locator(".scene .note")).toContainText("mirrored");
  await expect.poll(async () => (await lab.surface.screenshot()).equals(proper)).toBe(false);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await read(page, "ouc-ls"))[2]).toBe("0");
});

test("localizers are switched by the keyboard, in table and plots alike", async ({ page }) => {
  const lab = await openLocalize(page);
  await page.getByRole("button", { name: "All off" }).click();
  await expect(lab.status).toContainText("No localizer is switched on");
  const box = page.locator("aside").getByRole("checkbox", { name: /^OUC-LS/ });
  await box.focus();
  await page.keyboard.press("Space");
  await expect(errors(page).locator("[data-localizer]")).toHaveCount(1);
  await expect
    .poll(async () => (await table(lab, "RMSE(Q)"))[0].join(), { timeout: 30_000 })
    .toContain("OUC-LS");
  expect((await table(lab, "RMSE(Q)"))[0].join()).not.toContain("SUC-LS");
});

test("curves are sketched while one drags, refined when it rests, and stop when told", async ({ page }) => {
  test.setTimeout(180_000);
  const lab = await openLocalize(page);
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThanOrEqual(50);
  const points = async () => (await table(lab, "Position RMSE")).length - 1;
  const first = await points();
  const { x, y } = await lab.anchorPixel(2);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 50, { steps: 10 });
  await expect(page.locator(".told")).toContainText("20 of 20 trials", { timeout: 30_000 });
  await page.mouse.up();
  await expect(page.locator(".told")).toContainText("of 1000 trials");
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThanOrEqual(50);
  expect(await points()).toBe(first);
  await lab.type("Noise level σ", "0.02");
  await lab.settled();
  expect(await trials(page), "the sweep is the same whatever the noise is").toBeGreaterThanOrEqual(50);
  await lab.type("Seed", "7");
  await expect.poll(() => trials(page), { timeout: 60_000, intervals: [20] }).toBeGreaterThanOrEqual(50);
  await page.getByRole("button", { name: "Stop" }).click();
  await page.waitForTimeout(2500);
  const held = await trials(page);
  expect(held).toBeLessThan(1000);
  await page.waitForTimeout(1500);
  expect(await trials(page)).toBe(held);
  await page.getByRole("button", { name: "Go on" }).click();
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThan(held);
});

test("a press on a curve sets the noise, in one edit; so does Enter", async ({ page }) => {
  const lab = await openLocalize(page, "localization-paper");
  const plot = lab.plot("Orientation RMSE").getByRole("slider");
  await expect(plot).toBeVisible();
  const box = (await plot.boundingBox())!;
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.5 * box.height, { steps: 5 });
  await page.mouse.up();
  await expect(lab.status).toContainText(/ζ set to \d+ dB/);
  const set = Number(await lab.field("Signal to noise ζ").inputValue());
  expect(set).toBeGreaterThan(50);
  expect(set).not.toBe(60);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(lab.field("Signal to noise ζ")).toHaveValue("60");
  await plot.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await expect(lab.field("Signal to noise ζ")).toHaveValue("5");
});

test("the lab, its trial and its cloud travel in the link", async ({ page }) => {
  const lab = await openLocalize(page);
  await lab.type("Trials of the cloud", "20");
  await lab.type("Trial drawn", "3");
  await lab.pick("Group", "O(D)");
  await expect(page.getByRole("button", { name: "RMSE of 20 trials" })).toBeVisible();
  const before = await errors(page).innerText();
  // The address follows a moment after the edit.
  const settings = () => {
    const { hash } = new URL(page.url());
    return hash === "" ? null : unpack(hash)["localize"];
  };
  await expect.poll(settings).toMatchObject({ manifold: "o" });
  await page.reload();
  await expect(errors(page)).toBeVisible();
  expect(await errors(page).innerText()).toBe(before);
  await expect(lab.field("Trial drawn")).toHaveValue("3");
});

test("every preset can be localized, with numbers or a reason why there are none", async ({ page }) => {
  test.setTimeout(180_000);
  const health = new Health(page);
  const lab = await openLocalize(page);
  const presets = page.getByLabel("Preset", { exact: true });
  const names = await presets
    .locator("option")
    .evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value));
  for (const name of names.filter((value) => value !== "")) {
    await lab.openPreset(name);
    await lab.settled();
    await expect(lab.alert).toBeEmpty();
    await health.expectGood(lab);
    const angle = (await read(page, "ouc-ls"))[0];
    if (angle === "–") await expect(lab.status).toContainText("no estimate");
    else expect(Number(angle), name).toBeGreaterThan(0);
  }
});

test("axe finds nothing in any theme, nor on a phone", async ({ page }) => {
  const lab = await openLocalize(page);
  await lab.pick("OUC-TLS assumes", "its own");
  await lab.pick("Loss of ML", "Huber");
  await lab.openGroups();
  expect(await violations(page)).toEqual([]);
  for (const theme of ["dark", "projector"]) {
    await wear(page, theme);
    expect(await violations(page, "colours")).toEqual([]);
  }
  await page.setViewportSize({ width: 390, height: 844 });
  await lab.openSheet();
  expect(await violations(page)).toEqual([]);
});
