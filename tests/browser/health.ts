import { expect, type Page } from "@playwright/test";
import type { Lab } from "./lab";

/** What nobody may ever read on the page. */
const NONSENSE = /\bNaN\b|undefined|\[object|\bInfinity\b|\bnull\b/;

/** Listens for errors that nobody sees on the page. To be made before the page is opened. */
export class Health {
  readonly errors: string[] = [];

  constructor(page: Page) {
    page.on("pageerror", (error) => this.errors.push(error.stack ?? error.message));
    page.on("console", (message) => {
      if (message.type() === "error") this.errors.push(`console: ${message.text()}`);
    });
  }

  /** No error, no nonsense in texts, fields and labels, and a scene that is drawn. */
  async expectGood(lab: Lab): Promise<void> {
    expect(this.errors).toEqual([]);
    expect(await nonsense(lab.page)).toEqual([]);
    expect(await inked(lab)).toBeGreaterThan(0.003);
  }
}

export async function nonsense(page: Page): Promise<string[]> {
  const texts = await page.evaluate(() => {
    const lines = document.body.innerText.split("\n");
    for (const field of document.querySelectorAll("input")) lines.push(field.value);
    for (const text of document.querySelectorAll("svg text, svg title")) lines.push(text.textContent ?? "");
    for (const element of document.querySelectorAll("[aria-label], [title], [aria-valuetext]"))
      for (const name of ["aria-label", "title", "aria-valuetext"])
        lines.push(element.getAttribute(name) ?? "");
    return lines;
  });
  return texts.filter((line) => NONSENSE.test(line));
}

/** Share of pixels of the scene that are not the background, read from a picture of the page. */
export async function inked(lab: Lab): Promise<number> {
  const png = (await lab.surface.screenshot()).toString("base64");
  return lab.page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d")!;
    context.drawImage(image, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let i = 4; i < pixels.length; i += 4) {
      const difference = [0, 1, 2].reduce(
        (sum, channel) => sum + Math.abs(pixels[i + channel] - pixels[channel]),
        0,
      );
      if (difference > 30) count += 1;
    }
    return count / (pixels.length / 4);
  }, png);
}

/** The alert is one or two sentences that a student can read: not too long, ended, without code in it. */
export async function expectSentence(lab: Lab, about: RegExp): Promise<void> {
  const sentence = lab.alert.locator("p").first();
  await expect(sentence).toHaveText(about);
  const text = (await sentence.innerText()).trim();
  expect(text).toMatch(/^[\p{Lu}“‘0-9].{10,280}[.!?]$/su);
  expect(text).not.toMatch(/Error:|panicked|unreachable|\bat \w+ \(|=>|\{\}/);
}
