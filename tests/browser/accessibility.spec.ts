import AxeBuilder from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

const sizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];
const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

for (const theme of ["light", "dark", "projector"]) {
  for (const size of sizes) {
    test(`axe finds nothing: ${theme}, ${size.width} x ${size.height}`, async ({ page }) => {
      await page.setViewportSize(size);
      const lab = await Lab.open(page, `./?renderer=canvas2d&theme=${theme}`);
      const violations = async () =>
        (await new AxeBuilder({ page }).withTags(tags).analyze()).violations.map(
          ({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`,
        );
      expect(await violations()).toEqual([]);
      const at = await lab.anchorPixel(2);
      await page.mouse.click(at.x, at.y);
      await expect(page.getByRole("group", { name: "Selected anchor" })).toBeVisible();
      if (size.width < 700) await page.getByRole("button", { name: "Controls" }).click();
      for (const summary of await page.locator("aside summary").all()) await summary.click();
      await lab.type("Noise level σ", "-1");
      await expect(lab.alert).not.toBeEmpty();
      expect(await violations()).toEqual([]);
    });
  }
}

test("axe finds nothing in the dialogs", async ({ page }) => {
  await Lab.open(page);
  for (const name of ["Help", "Orientation error: data table"]) {
    await page.getByRole("button", { name }).click();
    await expect(page.getByRole("dialog")).toBeVisible();
    const { violations } = await new AxeBuilder({ page }).withTags(tags).analyze();
    expect(violations.map((violation) => violation.id)).toEqual([]);
    await page.keyboard.press("Escape");
  }
});

test("nothing jumps while numbers change", async ({ page }) => {
  const lab = await Lab.open(page);
  const layout = () =>
    page.evaluate(() =>
      [".scene", ".timeline", ".plots", "aside", ".readout"].map((part) => {
        const box = document.querySelector(part)?.getBoundingClientRect();
        return [part, box?.x, box?.y, box?.width, box?.height].join(" ");
      }),
    );
  const before = await layout();
  for (const level of ["0.0002", "0.5", "9"]) {
    await lab.type("Noise level σ", level);
    await expect(lab.status).toContainText("Noise level");
    expect(await layout()).toEqual(before);
  }
});
