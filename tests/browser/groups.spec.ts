import { expect, test } from "@playwright/test";
import { Lab } from "./lab";
import { SIZES } from "./states";

/** Everything typed in the controls outside the tables of points, by label. */
async function fields(lab: Lab): Promise<string[]> {
  await lab.openGroups();
  const labels = await lab.page.locator("aside .field:not(td .field) label").allInnerTexts();
  const boxes: string[] = [];
  for (const label of new Set(labels)) if ((await lab.field(label).count()) === 1) boxes.push(label);
  return boxes;
}

test("every number steps by keys, is marked as changed, and all goes back to the preset", async ({
  page,
}) => {
  test.setTimeout(180_000);
  const lab = await Lab.open(page);
  const before = await lab.readout();
  const labels = await fields(lab);
  expect(labels.length).toBeGreaterThan(25);
  for (const label of labels) {
    const value = await lab.field(label).inputValue();
    // Guessed angles of 0 step up, a share of 0 too; nothing here stands at its upper end.
    await lab.field(label).press("ArrowUp");
    expect(await lab.field(label).inputValue(), label).not.toBe(value);
  }
  await expect.poll(() => lab.readout()).not.toBe(before);
  const resets = page.locator("aside .head").getByRole("button", { name: /^Reset/ });
  expect(await resets.count()).toBeGreaterThan(6);
  while ((await resets.count()) > 0) await resets.first().click();
  await expect.poll(() => lab.readout()).toBe(before);
  await expect(page.locator("aside").getByRole("button", { name: /^Reset/ })).toHaveCount(0);
});

test("nothing typed breaks anything: the field says why, Escape brings the value back", async ({ page }) => {
  test.setTimeout(240_000);
  const errors: Error[] = [];
  page.on("pageerror", (error) => errors.push(error));
  const lab = await Lab.open(page);
  const before = await lab.readout();
  for (const label of await fields(lab)) {
    const field = lab.field(label);
    const value = await field.inputValue();
    for (const bad of ["abc", "", "1e300"]) {
      await lab.type(label, bad);
      await expect(field, `${label}: ${bad}`).toHaveAttribute("aria-invalid", "true");
      const reason = await field.evaluate(
        (input) =>
          document.getElementById(input.getAttribute("aria-describedby")?.split(" ")[1] ?? "")?.textContent,
      );
      expect(reason, `${label}: ${bad}`).toMatch(/\.$/);
      await field.press("Escape");
      await expect(field).toHaveValue(value);
      await expect(field).toHaveAttribute("aria-invalid", "false");
    }
  }
  expect(await lab.readout()).toBe(before);
  expect(errors).toEqual([]);
});

test("arrows step, Shift steps finely, Page Up and Page Down coarsely", async ({ page }) => {
  const lab = await Lab.open(page);
  const interval = lab.field("Interval");
  await expect(interval).toHaveValue("0.1");
  for (const [key, value] of [
    ["ArrowUp", "0.2"],
    ["Shift+ArrowDown", "0.19"],
    ["PageUp", "1.19"],
    ["PageDown", "0.19"],
  ]) {
    await interval.press(key);
    await expect(interval).toHaveValue(value);
  }
});

test("what is dropped when a field is left is said", async ({ page }) => {
  const lab = await Lab.open(page);
  const value = await lab.field("Interval").inputValue();
  await lab.field("Interval").fill("soon");
  await lab.field("Interval").press("Tab");
  await expect(lab.alert).toContainText("“soon” is not a number");
  await expect(lab.field("Interval")).toHaveValue(value);
});

test("groups stay open or closed at the next visit", async ({ page }) => {
  const lab = await Lab.open(page);
  await lab.openGroup("True start");
  await page.getByRole("heading", { name: "Estimators", exact: true }).getByRole("button").click();
  await page.reload();
  await expect(lab.field("Position, x")).toBeVisible();
  await expect(page.getByRole("checkbox", { name: /UC-KF/ })).toHaveCount(0);
});

test("a dangerous choice is explained where it is made", async ({ page }) => {
  const lab = await Lab.open(page);
  const settings = await lab.openGroup("Estimator settings");
  await expect(settings).not.toContainText("mirrored body.");
  await lab.pick("Manifold", "O(D)");
  await expect(settings).toContainText("may report a mirrored body.");
  await lab.openGroup("Sensors on the body");
  await lab.type("Sensor 1, z", "0.5");
  await lab.pick("UC-KF solves", "Q, then t");
  const [offset] = (await settings.innerText()).match(/[\d.]+(?= m off the body's origin)/) ?? [];
  expect(Number(offset)).toBeCloseTo(0.53 / 5, 3);
});

test("process noise far from the truth is told, and matched by a button", async ({ page }) => {
  const lab = await Lab.open(page);
  const group = await lab.openGroup("Process noise");
  const match = group.getByRole("button", { name: "Match the truth" });
  await expect(match).toBeDisabled();
  await lab.type("Turn per step σq", "0.01");
  await expect(group).toContainText("Orientation: 57.3 times too little");
  await match.click();
  await expect(group).toContainText("About what really disturbs the body.");
  await expect(match).toBeDisabled();
});

test("another noise model starts as loud as the last one", async ({ page }) => {
  const lab = await Lab.open(page);
  const [before] = await lab.bound();
  const group = await lab.openGroup("Ranges");
  await group.getByLabel("Noise", { exact: true }).selectOption({ label: "σ r on its square" });
  await expect(lab.field("Noise level σ")).toHaveValue("0.02");
  await expect.poll(async () => (await lab.bound())[0]).toBe(before);
  await group.getByLabel("Noise", { exact: true }).selectOption({ label: "time of arrival" });
  await expect(lab.field("Signal to noise ζ")).not.toHaveValue("");
  await expect(group).toContainText("0.0100 m on the median range");
});

test("anchors are arranged by one press, and that is one edit", async ({ page }) => {
  const lab = await Lab.open(page);
  const first = await lab.anchor(1);
  await page.getByRole("button", { name: "Ceiling" }).click();
  await expect(lab.status).toContainText("The 6 anchors lie in one plane");
  await page.getByRole("button", { name: /^Undo/ }).click();
  await expect.poll(() => lab.anchor(1)).toBe(first);
});

test("a body is chosen, made larger, and a sensor moved", async ({ page }) => {
  const lab = await Lab.open(page);
  const group = await lab.openGroup("Sensors on the body");
  await group.getByLabel("Topology").selectOption({ label: "Cube" });
  await expect(lab.field("Sensor 8, x")).toBeVisible();
  await lab.type("Length", "2");
  const corner = Math.abs(Number((await lab.field("Sensor 8, x").inputValue()).replace("−", "-")));
  expect(corner).toBeCloseTo(2 / Math.sqrt(12), 4);
  await lab.type("Sensor 8, x", "3");
  await expect(group.getByLabel("Topology")).toHaveValue("");
  await group.getByRole("button", { name: "Centre them" }).click();
  await expect(group).toContainText("Centred on the body's origin");
});

for (const size of SIZES) {
  test(`the widest theme needs no sideways scrolling: ${size.width} x ${size.height}`, async ({ page }) => {
    await page.setViewportSize(size);
    const lab = await Lab.open(page, "./?renderer=canvas2d&theme=projector");
    await page.getByRole("button", { name: "NEES column" }).click();
    await lab.openGroups();
    const tooWide = await page.evaluate(() =>
      [...document.querySelectorAll("aside, aside *, .readout")]
        .filter(
          (part) => part.scrollWidth > part.clientWidth + 1 && getComputedStyle(part).display !== "inline",
        )
        .filter((part) => !part.matches("input, .visually-hidden, .below, select"))
        .map((part) => `${part.tagName} ${part.className}: ${part.scrollWidth} in ${part.clientWidth}`),
    );
    expect(tooWide).toEqual([]);
  });
}
