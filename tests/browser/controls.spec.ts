import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

test("another seed is another run, the old one brings the old numbers back", async ({ page }) => {
  const lab = await Lab.open(page);
  const [seed, before] = [await lab.field("Seed").inputValue(), await lab.readout()];
  await lab.type("Seed", "77");
  await expect.poll(() => lab.readout()).not.toBe(before);
  await lab.type("Seed", seed);
  await expect.poll(() => lab.readout()).toBe(before);
});

test("more noise raises bound and errors", async ({ page }) => {
  const lab = await Lab.open(page);
  const [bound] = await lab.bound();
  const level = Number(await lab.field("Noise level σ").inputValue());
  await lab.type("Noise level σ", String(level * 10));
  await expect.poll(async () => Number((await lab.bound())[0])).toBeGreaterThan(2 * Number(bound));
});

test("the threshold decides how often ET-KF projects", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.type("ET threshold ε", "0");
  const all = Number(await lab.step.innerText());
  await expect(lab.status).toContainText(`projected at ${all} of ${all} steps`);
  await expect(page.locator(".timeline .marks path")).toHaveAttribute("data-count", String(all));
  await lab.type("ET threshold ε", "1000");
  await expect(lab.status).toContainText(`projected at 0 of ${all} steps`);
  expect(await lab.errors("et-kf")).toEqual(await lab.errors("kf"));
});

test("estimators are switched off and on", async ({ page }) => {
  const lab = await Lab.open(page);
  const [kf, uckf] = [page.locator('[data-estimator="kf"]'), await lab.errors("uc-kf")];
  await page.getByRole("checkbox", { name: "KF Kalman filter" }).uncheck();
  await expect(kf).toHaveCount(0);
  expect(await lab.errors("uc-kf")).toEqual(uckf);
  await page.getByRole("checkbox", { name: "KF Kalman filter" }).check();
  await expect(kf).toHaveCount(1);
});

test("a slider in motion is one edit", async ({ page }) => {
  const lab = await Lab.open(page);
  const before = await lab.readout();
  const box = await page.getByRole("slider", { name: "Noise level σ, slider" }).boundingBox();
  if (!box) throw new Error("no slider");
  await page.mouse.move(box.x + box.width * 0.4, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.8, box.y + box.height / 2, {
    steps: 10,
  });
  await page.mouse.up();
  await expect.poll(() => lab.readout()).not.toBe(before);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => lab.readout()).toBe(before);
  await expect(page.getByRole("button", { name: "Undo" })).toBeDisabled();
});

test("every preset opens, and Reset brings one back", async ({ page }) => {
  const lab = await Lab.open(page);
  const chooser = page.getByLabel("Preset", { exact: true });
  for (const name of await chooser.locator("option").allInnerTexts()) {
    await chooser.selectOption(name);
    if (name !== (await chooser.locator("option").first().innerText()))
      await expect(lab.status).toContainText(`Preset “${name}” opened`);
    await expect(lab.alert).toBeEmpty();
    expect((await lab.bound())[0]).toMatch(/^[\d.e−]+$/);
  }
  const before = await lab.readout();
  await lab.type("Seed", "4711");
  await expect.poll(() => lab.readout()).not.toBe(before);
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect.poll(() => lab.readout()).toBe(before);
});

test("a plot has its numbers as a table", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.plotMenu("Orientation error", "Data table");
  const dialog = page.getByRole("dialog");
  const rows = dialog.locator("tbody tr");
  await expect(rows).toHaveCount(Number(await lab.step.innerText()));
  const column = await dialog
    .locator("thead th", { hasText: /^UC-KF$/ })
    .evaluate((cell) => (cell as HTMLTableCellElement).cellIndex);
  const last = await rows.last().locator("th, td").nth(column).innerText();
  expect(last).toBe((await lab.errors("uc-kf"))[0]);
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
});
