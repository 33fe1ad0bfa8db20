import { execFileSync } from "node:child_process";
import { expect, type Page, test } from "@playwright/test";
import { readTable } from "./csv";
import { Lab } from "./lab";

const ROOT = new URL("../..", import.meta.url).pathname;
const FIRST_PICTURE = 200;

async function openStudy(page: Page): Promise<Lab> {
  const lab = await Lab.open(page);
  await page.getByRole("button", { name: "Monte-Carlo" }).click();
  return lab;
}

const trials = async (page: Page): Promise<number> =>
  Number.parseInt(await page.getByTestId("trials").innerText(), 10);

/** Waits for a picture of so many trials, stops there, and waits for the blocks that were begun. */
async function stopAfter(page: Page, count: number): Promise<number> {
  await expect.poll(() => trials(page), { timeout: 60_000, intervals: [20] }).toBeGreaterThanOrEqual(count);
  await page.getByRole("button", { name: "Stop" }).click();
  let last = -1;
  const settled = async () => {
    const before = last;
    last = await trials(page);
    return last === before;
  };
  await expect.poll(settled, { timeout: 30_000, intervals: [2000] }).toBe(true);
  return last;
}

/** The numbers of a plot as a reader saves them. */
async function saved(lab: Lab, title: string): Promise<{ trials: number; rows: Record<string, string>[] }> {
  const download = lab.page.waitForEvent("download");
  await lab.plotMenu(title, "Save as CSV");
  const stream = await (await download).createReadStream();
  let text = "";
  for await (const chunk of stream) text += String(chunk);
  const { comments, rows } = readTable(text);
  return { trials: Number(/trials 0 to (\d+)/.exec(comments)?.[1]) + 1, rows };
}

/** The scenario at hand, saved as a file. */
async function savedScenario(page: Page): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Scenario as a file (JSON)" }).click();
  return (await download).path();
}

/** The same study by the command line. */
function commandLine(scenario: string, count: number): Record<string, string>[] {
  const options = ["study", scenario, "--trials", String(count), "--format", "csv"];
  const text = execFileSync("cargo", ["run", "--quiet", "--bin", "rangelab", "--", ...options], {
    cwd: ROOT,
    encoding: "utf8",
  });
  return readTable(text).rows;
}

const DEGREES = 180 / Math.PI;
/** What a plot shows of each estimator, and the columns of the command line that say the same. */
const FIGURES = [
  { plot: "Orientation RMSE", unit: " in deg", column: "rms_angle_rad", factor: DEGREES },
  { plot: "Position RMSE", unit: " in m", column: "rmse_position_m", factor: 1 },
  { plot: "Mean NEES / dof", unit: "", column: "nees_per_degree_of_freedom", factor: 1 },
];
const LABELS = { kf: "KF", ortho: "KF-ortho", "uc-kf": "UC-KF", "et-kf": "ET-KF", eskf: "ESKF" };

test("averages of an earlier scene say that they are", async ({ page }) => {
  const lab = await openStudy(page);
  await stopAfter(page, FIRST_PICTURE);
  const before = page.getByText("of the scene before");
  await expect(before).toBeHidden();
  await lab.type("Seed", "31");
  await expect(before).toBeVisible();
  await page.keyboard.press("Control+z");
  await expect(before).toBeHidden();
});

test("the averages are those of the command line, to the last digit", async ({ page }) => {
  test.setTimeout(600_000);
  const lab = await openStudy(page);
  await stopAfter(page, FIRST_PICTURE);
  const pictures = [];
  for (const figure of FIGURES) pictures.push({ ...figure, ...(await saved(lab, figure.plot)) });
  const expected = commandLine(await savedScenario(page), pictures[0].trials);
  expect(pictures[0].trials).toBeGreaterThanOrEqual(FIRST_PICTURE);
  for (const { plot, unit, column, factor, rows } of pictures)
    for (const [name, label] of Object.entries(LABELS)) {
      const theirs = expected.filter((row) => row["kind"] === "estimator" && row["name"] === name);
      const [ours, errors] = [`${label}${unit}`, `${label} standard error${unit}`];
      expect(
        rows.map((row) => Number(row[ours])),
        `${plot}, ${label}`,
      ).toEqual(theirs.map((row) => Number(row[column]) * factor));
      expect(
        rows.map((row) => Number(row[errors])),
        `${plot}, ${label}`,
      ).toEqual(theirs.map((row) => Number(row[`${column}_standard_error`]) * factor));
    }
  const bound = expected.filter((row) => row["name"] === "posterior_crb");
  expect(pictures[0].rows.map((row) => Number(row["posterior CRB in deg"]))).toEqual(
    bound.map((row) => Number(row["rms_angle_rad"]) * DEGREES),
  );
});

test("a study stops where it is told and goes on from there", async ({ page }) => {
  await openStudy(page);
  await stopAfter(page, 40);
  await page.waitForTimeout(1500);
  const held = await trials(page);
  await page.waitForTimeout(1500);
  expect(await trials(page)).toBe(held);
  await page.getByRole("button", { name: "Go on" }).click();
  await expect.poll(() => trials(page), { timeout: 30_000 }).toBeGreaterThan(held);
});

test("while one drags, the old averages stay, dimmed, until new ones are there", async ({ page }) => {
  test.setTimeout(180_000);
  const lab = await openStudy(page);
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThanOrEqual(FIRST_PICTURE);
  await expect(page.locator(".plots figure.stale")).toHaveCount(0);
  const before = (await saved(lab, "Position RMSE")).rows;
  const { x, y } = await lab.anchorPixel(2);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 50, { steps: 10 });
  await expect(page.locator(".plots figure.stale").first()).toBeVisible();
  await expect(page.locator(".plots canvas").first()).toBeVisible();
  await page.mouse.up();
  await expect(page.locator(".plots figure.stale")).toHaveCount(0, { timeout: 60_000 });
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThanOrEqual(FIRST_PICTURE);
  expect((await saved(lab, "Position RMSE")).rows).not.toEqual(before);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(page.locator(".plots figure.stale").first()).toBeVisible();
  await expect(page.locator(".plots figure.stale")).toHaveCount(0, { timeout: 60_000 });
});

for (const [how, kill] of [
  [
    "crashes",
    () =>
      void setTimeout(() => {
        throw new Error("killed by the test");
      }),
  ],
  ["is silently gone", () => self.close()],
] as const)
  test(`a worker that ${how} is replaced; no trial is lost`, async ({ page }) => {
    test.setTimeout(180_000);
    const lab = await openStudy(page);
    await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThanOrEqual(20);
    const [first] = page.workers();
    await first.evaluate(kill);
    const before = await trials(page);
    await expect.poll(() => trials(page), { timeout: 90_000 }).toBeGreaterThan(before + 160);
    expect(page.workers()).not.toContain(first);
    await expect(page.getByRole("button", { name: "Try again" })).toHaveCount(0);
    const { trials: counted } = await saved(lab, "Position RMSE");
    expect(counted % 20).toBe(0);
  });

test("workers that cannot start are told in a sentence; the rest of the page works on", async ({ page }) => {
  await page.route("**/study-worker*", (route) =>
    route.fulfill({ contentType: "text/javascript", body: "throw new Error('no worker today')" }),
  );
  const lab = await openStudy(page);
  await expect(page.locator(".plots [role=status]")).toContainText("stopped", { timeout: 30_000 });
  await page.unroute("**/study-worker*");
  await page.getByRole("button", { name: "Try again" }).click();
  await expect.poll(() => trials(page), { timeout: 60_000 }).toBeGreaterThanOrEqual(20);
  await page.getByRole("button", { name: "One run" }).click();
  await expect(lab.plot("Orientation error")).toBeVisible();
  await expect.poll(() => page.workers().length).toBe(0);
});
