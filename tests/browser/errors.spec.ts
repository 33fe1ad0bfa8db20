import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

test("a value out of range is refused in a sentence and nothing is lost", async ({ page }) => {
  const lab = await Lab.open(page);
  const before = await lab.readout();
  const field = lab.field("Noise level σ");
  const value = await field.inputValue();
  for (const bad of ["0", "-1", "1e12"]) {
    await lab.type("Noise level σ", bad);
    await expect(lab.alert).toContainText("sigma");
    await expect(lab.alert).toContainText("stays as it was");
    await field.press("Escape");
    await expect(field).toHaveValue(value);
    expect(await lab.readout()).toBe(before);
  }
  await lab.type("Noise level σ", String(Number(value) * 2));
  await expect(lab.alert).toBeEmpty();
});

test("text that is no number is not taken", async ({ page }) => {
  const lab = await Lab.open(page);
  const before = await lab.readout();
  for (const bad of ["NaN", "abc", ""]) {
    await lab.type("Anchor 1, x", bad);
    await expect(lab.field("Anchor 1, x")).toHaveAttribute("aria-invalid", "true");
  }
  await lab.field("Seed").focus();
  await expect(lab.field("Anchor 1, x")).not.toHaveValue("");
  expect(await lab.readout()).toBe(before);
});

test("geometries that break estimators leave a live page", async ({ page }) => {
  const pageErrors: Error[] = [];
  page.on("pageerror", (error) => pageErrors.push(error));
  const lab = await Lab.open(page);
  const anchors = await page.locator("#scene-twin li").count();
  const place = async (number: number, [x, y, z]: [string, string, string]) => {
    await lab.type(`Anchor ${number}, x`, x);
    await lab.type(`Anchor ${number}, y`, y);
    await lab.type(`Anchor ${number}, z`, z);
  };
  for (let i = 1; i <= anchors; i++) await place(i, [String(i), "2", "1"]);
  await lab.surface.focus();
  for (let i = 1; i <= anchors; i++) await place(i, ["3", "2", "1"]);
  for (let i = anchors; i > 1; i--) await page.getByRole("button", { name: `Remove anchor ${i}` }).click();
  await expect(lab.scene.locator("canvas")).toBeVisible();
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect(lab.alert).toBeEmpty();
  expect((await lab.errors("uc-kf"))[0]).toMatch(/^[\d.]+$/);
  expect(pageErrors).toEqual([]);
});

test("without any anchor the page says so, and the last good run stays", async ({ page }) => {
  const lab = await Lab.open(page);
  const picture = await page.locator(".plots figure").first().screenshot();
  const remove = page.getByRole("button", { name: "Remove anchor 1" });
  for (let count = await page.locator("#scene-twin li").count(); count > 0; count--) await remove.click();
  await expect(lab.alert).not.toBeEmpty();
  expect((await lab.errors("uc-kf"))[0]).toMatch(/^[\d.]+$/);
  while (await page.getByRole("button", { name: "Undo" }).isEnabled()) await page.keyboard.press("Control+z");
  await expect(lab.alert).toBeEmpty();
  await expect
    .poll(async () => (await page.locator(".plots figure").first().screenshot()).equals(picture))
    .toBe(true);
});
