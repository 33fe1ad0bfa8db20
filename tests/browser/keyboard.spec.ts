import { expect, test } from "@playwright/test";
import { Lab } from "./lab";

test("the whole task without a pointer: choose an anchor, move it, lift it, let go, undo", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  await lab.surface.focus();
  await page.keyboard.press("n");
  await page.keyboard.press("n");
  await expect(lab.status).toContainText("Anchor 2 selected");
  const [start, readout] = [await lab.anchor(2), await lab.readout()];
  await page.keyboard.press("ArrowRight");
  await expect(lab.status).toContainText("Anchor 2 moved to");
  await page.keyboard.press("Shift+ArrowUp");
  await page.keyboard.press("PageUp");
  expect(await lab.anchor(2)).not.toBe(start);
  expect(await lab.readout()).not.toBe(readout);
  for (let i = 0; i < 3; i++) await page.keyboard.press("Control+z");
  await expect.poll(() => lab.anchor(2)).toBe(start);
  await expect.poll(() => lab.readout()).toBe(readout);
  await page.keyboard.press("Escape");
  await expect(page.getByRole("group", { name: "Selected anchor" })).toBeHidden();
});

test("a held arrow key is one edit", async ({ page }) => {
  const lab = await Lab.open(page);
  const start = await lab.anchor(1);
  await lab.surface.focus();
  await page.keyboard.press("1");
  for (let i = 0; i < 5; i++) await page.keyboard.down("ArrowRight");
  await page.keyboard.up("ArrowRight");
  expect(await lab.anchor(1)).not.toBe(start);
  await page.keyboard.press("Control+z");
  await expect.poll(() => lab.anchor(1)).toContain(start.replace(", selected", ""));
});

test("an anchor is placed without dragging: press it, then the buttons or typed numbers", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  const at = await lab.anchorPixel(2);
  await page.mouse.click(at.x, at.y);
  const card = page.getByRole("group", { name: "Selected anchor" });
  await expect(card).toContainText("Anchor 2");
  const before = await lab.anchor(2);
  await card.getByRole("button", { name: "x: more" }).click();
  await expect.poll(() => lab.anchor(2)).not.toBe(before);
  await card.getByRole("textbox", { name: "z" }).fill("1,25");
  await page.keyboard.press("Enter");
  await expect.poll(() => lab.anchor(2)).toContain(", 1.25)");
});

test("anchors are added and removed, in the scene and in the table", async ({ page }) => {
  const lab = await Lab.open(page);
  const items = page.locator("#scene-twin li");
  const count = await items.count();
  await page.getByRole("button", { name: "Add an anchor" }).click();
  await expect(items).toHaveCount(count + 1);
  await page.getByRole("button", { name: `Remove anchor ${count + 1}` }).click();
  await expect(items).toHaveCount(count);
  await lab.surface.focus();
  await page.keyboard.press("a");
  await expect(items).toHaveCount(count + 1);
  await page.keyboard.press("Delete");
  await expect(items).toHaveCount(count);
  await expect(lab.status).toContainText(`Anchor ${count + 1} removed`);
});

test("every control can be reached by Tab and shows its focus", async ({ page }) => {
  await Lab.open(page);
  await page.locator("body").focus();
  const seen: string[] = [];
  for (let i = 0; i < 200; i++) {
    await page.keyboard.press("Tab");
    const [name, outline] = await page.evaluate(() => {
      const element = document.activeElement as HTMLElement;
      const style = getComputedStyle(element);
      const name = element.getAttribute("aria-label") || element.textContent?.trim() || element.id;
      return [`${element.tagName} ${name}`, element === document.body ? "body" : style.outlineStyle] as const;
    });
    if (outline === "body") break;
    expect(outline, name).not.toBe("none");
    seen.push(name);
  }
  for (const part of [
    "Share",
    "Help",
    "Anchors, body",
    "Play",
    "Step",
    "scale, table, files",
    "ET threshold",
    "Settings",
    "Add an anchor",
  ])
    expect(seen.join("\n")).toContain(part);
  expect(seen.length).toBeGreaterThan(40);
});

test("Home, End and Space scroll what has the focus to be scrolled, and elsewhere go along the run", async ({
  page,
}) => {
  const lab = await Lab.open(page);
  await lab.openGroups();
  const panel = page.getByRole("group", { name: "Settings" });
  const first = await lab.step.innerText();
  await panel.focus();
  await page.keyboard.press("End");
  await expect.poll(() => panel.evaluate((element) => element.scrollTop)).toBeGreaterThan(100);
  expect(await lab.step.innerText()).toBe(first);
  await lab.surface.focus();
  await page.keyboard.press("Home");
  await expect(lab.step).toHaveText("1");
});
