import { expect, type Locator, type Page } from "@playwright/test";

/** The Track lab as a visitor sees it: reads its numbers, finds its parts. */
export class Lab {
  readonly scene: Locator;
  readonly surface: Locator;
  readonly status: Locator;
  readonly alert: Locator;
  readonly step: Locator;

  constructor(readonly page: Page) {
    this.scene = page.locator(".scene");
    this.surface = this.scene.getByRole("application");
    this.status = page.locator(".status");
    this.alert = page.getByRole("alert");
    this.step = page.getByTestId("step");
  }

  /** Opens the page and waits until the scene's own renderer has taken over from the plain canvas. */
  static async open(page: Page, address = "./?renderer=canvas2d&theme=light"): Promise<Lab> {
    await page.goto(address);
    const lab = new Lab(page);
    await expect(lab.scene).not.toHaveAttribute("data-backend", "", {
      timeout: 60_000,
    });
    await expect(lab.status).toContainText("Ready");
    return lab;
  }

  /** Orientation error in degrees and position error in metres at the step shown. */
  errors(estimator: string): Promise<string[]> {
    return this.page.locator(`[data-estimator="${estimator}"] td`).allInnerTexts();
  }

  bound(name = "posterior_crb"): Promise<string[]> {
    return this.page.locator(`[data-bound="${name}"] td`).allInnerTexts();
  }

  /** All numbers of the table of errors, as one text. */
  readout(): Promise<string> {
    return this.page.getByRole("table", { name: "Errors at this step" }).innerText();
  }

  async anchor(number: number): Promise<string> {
    const item = this.page.locator("#scene-twin li").nth(number - 1);
    return (await item.textContent()) ?? "";
  }

  /** The pixel of an anchor: its label says where it is. */
  async anchorPixel(number: number): Promise<{ x: number; y: number }> {
    return this.pixelOf(`${number - 1}`);
  }

  /** The pixel of the point that a label of the scene names: "0" is the first anchor, "start" the start of the body. */
  async pixelOf(id: string): Promise<{ x: number; y: number }> {
    const label = this.page.locator(`svg.labels text[data-id="${id}"]`);
    const box = await this.surface.boundingBox();
    if (!box) throw new Error("the scene is not on the page");
    const [x, y] = await Promise.all([label.getAttribute("data-x"), label.getAttribute("data-y")]);
    return { x: box.x + Number(x), y: box.y + Number(y) };
  }

  /** A picture of the middle of the scene, where the body is: no anchor under the pointer is in it. */
  async middle(): Promise<Buffer> {
    await this.settled();
    const box = await this.surface.boundingBox();
    if (!box) throw new Error("the scene is not on the page");
    const [width, height] = [box.width / 4, box.height / 4];
    const clip = { x: box.x + 1.5 * width, y: box.y + 1.5 * height, width, height };
    return this.page.screenshot({ clip });
  }

  async drag(number: number, dx: number, dy: number): Promise<void> {
    const from = await this.anchorPixel(number);
    await this.page.mouse.move(from.x, from.y);
    await this.page.mouse.down();
    await this.page.mouse.move(from.x + dx, from.y + dy, { steps: 8 });
    await this.page.mouse.up();
  }

  plot(title: string): Locator {
    return this.page.locator(".plots figure").filter({ hasText: title });
  }

  /** Opens the menu of a plot and chooses something from it. */
  async plotMenu(title: string, choice?: string): Promise<void> {
    await this.page.getByRole("button", { name: `${title}: scale, table, files` }).click();
    if (choice) await this.page.getByRole("button", { name: choice, exact: true }).click();
  }

  field(label: string): Locator {
    return this.page.getByRole("textbox", { name: label, exact: true });
  }

  async type(label: string, value: string): Promise<void> {
    await this.field(label).fill(value);
    await this.field(label).press("Enter");
  }

  /** Chooses an anchor by a press on it. */
  async choose(number: number): Promise<void> {
    const at = await this.anchorPixel(number);
    await this.page.mouse.click(at.x, at.y);
    await expect(this.page.getByRole("group", { name: /^Selected (anchor|beacon|node)$/ })).toBeVisible();
  }

  async openPreset(name: string): Promise<void> {
    const list = this.page.getByLabel("Preset", { exact: true });
    const title = await list.locator(`option[value="${name}"]`).innerText();
    await list.selectOption({ value: name });
    await expect(this.status).toContainText(`Preset “${title}” opened`);
  }

  /** On a narrow screen the controls are a sheet. */
  async openSheet(): Promise<void> {
    const button = this.page.getByRole("button", { name: "Controls", exact: true });
    if (await button.isVisible()) await button.click();
  }

  /** Opens every folded group of the controls. */
  async openGroups(): Promise<void> {
    await this.openSheet();
    const folded = this.page.locator("aside h2 > button[aria-expanded=false]");
    while ((await folded.count()) > 0) await folded.first().click();
  }

  /** A group of the controls, opened. */
  async openGroup(title: string): Promise<Locator> {
    await this.openSheet();
    const group = this.page.getByRole("region", { name: title, exact: true });
    const heading = group.locator("h2 > button");
    if ((await heading.getAttribute("aria-expanded")) === "false") await heading.click();
    return group;
  }

  /** Makes one of a few choices that stand side by side. */
  async pick(label: string, option: string): Promise<void> {
    const choices = this.page.getByRole("radiogroup", { name: label, exact: true });
    await choices.getByRole("radio", { name: option, exact: true }).check();
  }

  /** Waits until what is drawn has caught up with the state. */
  async settled(): Promise<void> {
    await this.page.evaluate(
      () =>
        new Promise<void>((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve()))),
    );
  }

  async enableAllEstimators(): Promise<void> {
    for (const box of await this.page.locator("aside").getByRole("checkbox", { name: /KF/ }).all())
      await box.check();
  }

  /** Plays a run of so many steps, over and over. */
  async play(speed: string, steps: number): Promise<void> {
    await this.type("Steps", String(steps));
    await this.page.getByLabel("Speed").selectOption(speed);
    await this.keepPlaying();
  }

  /** Presses Play where playing has come to its end. */
  async keepPlaying(): Promise<void> {
    const play = this.page.getByRole("button", { name: "Play", exact: true });
    if (await play.isVisible()) await play.click();
  }
}
