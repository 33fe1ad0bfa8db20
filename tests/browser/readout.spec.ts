import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

const NEAREST =
  /Nearest so far: (.+?), ([\d.]+)° and ([\d.]+) m off; the bound is ([\d.]+)° and ([\d.]+) m\./;

test("the sentence says the numbers of the table, at every step", async ({ page }) => {
  const lab = await Lab.open(page);
  for (const key of ["End", ",", ",", "Home"]) {
    await page.locator("body").press(key);
    const step = await lab.step.innerText();
    await expect.poll(() => lab.status.innerText()).toContain(Number(step) < 60 ? "so far" : "of 60 steps");
    await expect
      .poll(async () => {
        const [, label, angle, position, ...bound] = (await lab.status.innerText()).match(NEAREST) ?? [];
        const row = page.locator(".readout tbody tr", {
          has: page.getByRole("rowheader", { name: label, exact: true }),
        });
        const name = label === "ESKF raw" ? "posterior_crb_raw" : "posterior_crb";
        const told = [angle, position, ...bound].join(" ");
        return told === [...(await row.locator("td").allInnerTexts()), ...(await lab.bound(name))].join(" ");
      })
      .toBe(true);
  }
});

test("the live region hears edits at once and steps when they rest, not while playing", async ({ page }) => {
  const lab = await Lab.open(page);
  const live = page.locator(".stage [aria-live=polite]");
  await lab.type("Seed", "5");
  await expect(live).toContainText(/^Seed set to 5\. Nearest so far/);
  await live.evaluate((element) => {
    const said: string[] = [];
    Object.assign(window, { said });
    new MutationObserver(() => said.push(element.textContent ?? "")).observe(element, {
      childList: true,
      characterData: true,
      subtree: true,
    });
  });
  const said = () => page.evaluate(() => (window as unknown as { said: string[] }).said);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => lab.step.innerText()).not.toBe("1");
  await page.waitForTimeout(1500);
  expect(await said()).toEqual([]);
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await expect.poll(said).toHaveLength(1);
  expect((await said())[0]).toMatch(/^Step \d+ of 60\. /);
});

test("while playing the sentence changes no faster than it can be read", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.status.evaluate((element) => {
    const changes: number[] = [];
    Object.assign(window, { changes });
    new MutationObserver(() => changes.push(performance.now())).observe(element, {
      childList: true,
      characterData: true,
      subtree: true,
    });
  });
  await page.getByLabel("Speed").selectOption({ label: "20 steps/s" });
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForTimeout(2600);
  await page
    .getByRole("button", { name: /Pause|Play/, exact: true })
    .first()
    .click();
  const changes = await page.evaluate(() => (window as unknown as { changes: number[] }).changes);
  expect(changes.length).toBeGreaterThan(1);
  expect(changes.length).toBeLessThanOrEqual(4);
});

test("weak geometry is told, and gone when the anchors are better", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.openPreset("coplanar-ceiling");
  await expect(lab.status).toContainText("Five anchors lie within");
  await expect(lab.status).toContainText("height is known");
  await lab.type("Anchor 1, z", "0.1");
  await lab.type("Anchor 3, z", "0.1");
  await expect(lab.status).not.toContainText("height is known");
});

test("NEES stands in the table on demand, also at the next visit", async ({ page }) => {
  const lab = await Lab.open(page);
  expect(await lab.errors("uc-kf")).toHaveLength(2);
  await page.getByRole("button", { name: "NEES column" }).click();
  const [, , nees] = await lab.errors("uc-kf");
  expect(Number(nees)).toBeGreaterThan(0);
  await page.reload();
  await expect.poll(async () => (await lab.errors("uc-kf"))[2]).toBe(nees);
});

test("beside Monte-Carlo plots the table holds root mean square errors, and one run's again after", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const table = page.getByRole("table", { name: "Errors at this step" });
  const before = await lab.readout();
  await expect(table).toContainText("Errors of this run");
  await page.getByText("Monte-Carlo", { exact: true }).click();
  await expect(table).toContainText(/RMSE of \d+ trials/, { timeout: 30_000 });
  const [angle] = await lab.errors("uc-kf");
  const [bound] = await lab.bound();
  expect(Number(angle)).toBeGreaterThan(0.9 * Number(bound));
  await page.getByText("One run", { exact: true }).click();
  await expect.poll(() => lab.readout()).toBe(before);
});
