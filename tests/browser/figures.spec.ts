import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { violations } from "./axe";
import { Lab } from "./lab";

const ROOT = resolve(import.meta.dirname, "../..");
const FORTY = "rangelab figure tracking-2 --trials 40 --seed 1";

function figures(page: Page): Locator {
  return page.getByRole("dialog", { name: "The papers’ figures" });
}

async function open(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Figures", exact: true }).click();
  await expect(figures(page)).toBeVisible({ timeout: 30_000 });
  return figures(page);
}

async function compute(dialog: Locator, trials: number): Promise<void> {
  await dialog.getByRole("textbox", { name: "Trials" }).fill(String(trials));
  await dialog.getByRole("button", { name: "Compute" }).click();
}

async function saved(page: Page, dialog: Locator, format: string): Promise<string> {
  const download = page.waitForEvent("download");
  await dialog.getByRole("button", { name: `Save as ${format}` }).click();
  return readFileSync(await (await download).path(), "latin1");
}

/** The same figure by the command line that stands below it. */
function commandLine(command: string, format: string): string {
  const options = ["run", "--quiet", "--bin", "rangelab", "--", ...command.split(" ").slice(1)];
  const text = execFileSync("cargo", [...options, "--format", format], { cwd: ROOT, maxBuffer: 1e8 });
  return text.toString("latin1");
}

test("a figure is computed with progress, and its files are those of the command line", async ({ page }) => {
  test.setTimeout(1_200_000);
  await Lab.open(page);
  const dialog = await open(page);
  await compute(dialog, 40);
  const progress = dialog.getByTestId("figure-progress");
  await expect(progress).toHaveText(/\d+ of \d+ jobs, (starting|about \d+ s left)/);
  await expect(progress).toHaveText(/jobs, complete/, { timeout: 120_000 });
  await expect(dialog.locator("code")).toHaveText(FORTY);
  await expect(dialog.getByTestId("figure-caption")).toContainText("over 40 trials (seed 1)");
  await dialog.getByRole("button", { name: "Copy command" }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(FORTY);
  const json = await saved(page, dialog, "JSON");
  const csv = await saved(page, dialog, "CSV");
  expect(json).toBe(commandLine(FORTY, "json").trimEnd());
  expect(csv).toBe(commandLine(FORTY, "csv"));
  const claims = JSON.parse(json).claims as { what: string; verdict: string }[];
  const verdicts = await dialog.locator("td.verdict").allInnerTexts();
  const words = (verdict: string) => verdict.replaceAll("-", " ");
  expect(verdicts.map((text) => text.slice(2).trim()).toSorted()).toEqual(
    claims.map(({ verdict }) => words(verdict)).toSorted(),
  );
  for (const format of ["SVG", "PNG"]) {
    const file = await saved(page, dialog, format);
    expect(file).toContain(FORTY);
    expect(file).toContain("sensors");
  }
  expect(await violations(page)).toEqual([]);
});

test("a figure of indoor tracking is that of the command line", async ({ page }) => {
  test.setTimeout(1_200_000);
  await Lab.open(page);
  const dialog = await open(page);
  await dialog.getByRole("button", { name: /Distribution of the RMSE of the position/ }).click();
  await compute(dialog, 40);
  await expect(dialog.getByTestId("figure-progress")).toHaveText(/jobs, complete/, { timeout: 120_000 });
  const command = "rangelab figure indoor-9 --trials 40 --seed 1";
  await expect(dialog.locator("code")).toHaveText(command);
  expect(await saved(page, dialog, "JSON")).toBe(commandLine(command, "json").trimEnd());
  expect(await saved(page, dialog, "CSV")).toBe(commandLine(command, "csv"));
  expect(await violations(page)).toEqual([]);
});

test("a figure of relative kinematics is that of the command line", async ({ page }) => {
  test.setTimeout(1_200_000);
  await Lab.open(page);
  const dialog = await open(page);
  await dialog.getByRole("button", { name: /^Fig\. 2b/ }).click();
  await compute(dialog, 20);
  await expect(dialog.getByTestId("figure-progress")).toHaveText(/jobs, complete/, { timeout: 240_000 });
  const command = "rangelab figure kinematics-2b --trials 20 --seed 1";
  await expect(dialog.locator("code")).toHaveText(command);
  expect(await saved(page, dialog, "JSON")).toBe(commandLine(command, "json").trimEnd());
  expect(await saved(page, dialog, "CSV")).toBe(commandLine(command, "csv"));
  expect(await violations(page)).toEqual([]);
});

test("a figure can be cancelled; what is there stays, and files are made of complete ones only", async ({
  page,
}) => {
  test.setTimeout(180_000);
  await Lab.open(page);
  const dialog = await open(page);
  await compute(dialog, 100_000);
  await expect(dialog.getByTestId("figure-caption")).toBeVisible({ timeout: 120_000 });
  await dialog.getByRole("button", { name: "Cancel" }).click();
  const progress = dialog.getByTestId("figure-progress");
  await expect(progress).toHaveText(/cancelled/);
  const there = await progress.innerText();
  await expect(dialog.getByRole("button", { name: "Save as JSON" })).toBeDisabled();
  await expect(dialog.getByRole("button", { name: "Compute" })).toBeEnabled();
  await page.waitForTimeout(1500);
  expect(await progress.innerText()).toBe(there);
});

test("the list is reached, chosen from and left by keyboard", async ({ page }) => {
  await Lab.open(page);
  await page.keyboard.press("r");
  const dialog = figures(page);
  await expect(dialog).toBeVisible({ timeout: 30_000 });
  const third = dialog.getByRole("button", { name: /^Fig\. 3/ }).first();
  await third.focus();
  await page.keyboard.press("Enter");
  await expect(third).toHaveAttribute("aria-current", "true");
  await expect(dialog.getByText("The paper says:")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
});

test("an engine that does not come is told in a sentence, and can be asked for again", async ({ page }) => {
  await page.route("**/rangelab_figures_bg*.wasm", (route) => route.abort());
  const lab = await Lab.open(page);
  await page.getByRole("button", { name: "Figures", exact: true }).click();
  await expect(lab.alert).toContainText("The figures could not be loaded");
  await page.unroute("**/rangelab_figures_bg*.wasm");
  await open(page);
});

test("what a figure simulates opens in its lab, and one undo comes back to the scene before", async ({
  page,
}) => {
  test.setTimeout(180_000);
  const lab = await Lab.open(page);
  const before = await lab.anchor(1);
  const dialog = await open(page);
  await dialog
    .getByRole("button", { name: /^Fig\. 7/ })
    .first()
    .click();
  await compute(dialog, 20);
  await dialog
    .getByRole("button", { name: /in Localize$/ })
    .first()
    .click();
  await expect(dialog).toBeHidden();
  const localize = page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Localize" });
  await expect(localize).toHaveAttribute("aria-current", "page");
  await expect.poll(() => lab.anchor(1)).not.toBe(before);
  await page.keyboard.press("Control+z");
  await expect.poll(() => lab.anchor(1)).toBe(before);
});
