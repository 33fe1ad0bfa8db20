import type { Lab } from "./lab";

/** Numbers from 0 to 1, the same for the same seed (mulberry32). */
export function numbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const KEYS = [
  ...["Tab", "Enter", "Space", "Escape", "Home", "End", "PageUp", "PageDown", "Delete"],
  ...["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Shift+ArrowLeft", "Shift+Tab"],
  ...[
    "Control+z",
    "Control+y",
    "Control+Shift+z",
    "Control+a",
    ",",
    ".",
    "+",
    "-",
    "a",
    "n",
    "p",
    "1",
    "7",
    "?",
  ],
];
const RUBBISH = [
  "",
  "abc",
  "-",
  "1e999",
  "-1e9",
  "0",
  "1e-300",
  "1,5",
  "ß∞",
  "0x10",
  "3..4",
  "1e9",
  "7",
  "999999999",
];

/** Does what a visitor without a plan does, one thing after the other; tells each, so that a failure can be read. */
export class Monkey {
  readonly done: string[] = [];
  readonly #random: () => number;

  constructor(
    readonly lab: Lab,
    seed: number,
  ) {
    this.#random = numbers(seed);
  }

  async act(): Promise<void> {
    const acts = [
      this.#press,
      this.#drag,
      this.#drag,
      this.#key,
      this.#key,
      this.#type,
      this.#choose,
      this.#undo,
    ];
    await this.#one(acts).call(this);
  }

  #one<T>(from: readonly T[]): T {
    return from[Math.floor(this.#random() * from.length)];
  }

  #place(): { x: number; y: number } {
    const { width, height } = this.lab.page.viewportSize() ?? { width: 1000, height: 700 };
    return { x: Math.floor(this.#random() * width), y: Math.floor(this.#random() * height) };
  }

  async #press(): Promise<void> {
    const { x, y } = this.#place();
    this.done.push(`press ${x}, ${y}`);
    await this.lab.page.mouse.click(x, y);
  }

  /** Where the labels of the scene say that something is. */
  async #things(): Promise<{ x: number; y: number }[]> {
    const box = await this.lab.surface.boundingBox();
    if (!box) return [];
    return this.lab.page.locator("svg.labels text[data-x]").evaluateAll(
      (labels, { x, y }) =>
        labels.map((label) => ({
          x: x + Number(label.getAttribute("data-x")),
          y: y + Number(label.getAttribute("data-y")),
        })),
      box,
    );
  }

  async #drag(): Promise<void> {
    const things = await this.#things();
    const onThing = things.length > 0 && this.#random() < 0.7;
    const [from, to] = [onThing ? this.#one(things) : this.#place(), this.#place()];
    this.done.push(`drag ${from.x.toFixed()}, ${from.y.toFixed()} to ${to.x}, ${to.y}`);
    const { mouse } = this.lab.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(to.x, to.y, { steps: 3 });
    await mouse.up();
  }

  async #key(): Promise<void> {
    const key = this.#one(KEYS);
    this.done.push(`key ${key}`);
    await this.lab.page.keyboard.press(key);
  }

  /** Into whatever text field comes. */
  async #type(): Promise<void> {
    const fields = this.lab.page.locator('input[type="text"]:visible');
    const names = await fields.evaluateAll((all) =>
      all.map((field) => (field as HTMLInputElement).labels?.[0]?.textContent ?? field.ariaLabel ?? field.id),
    );
    if (names.length === 0) return;
    const [index, text] = [Math.floor(this.#random() * names.length), this.#one(RUBBISH)];
    this.done.push(`type "${text}" into “${names[index]}”`);
    await quickly(() => fields.nth(index).fill(text, { timeout: 1000 }));
    await this.lab.page.keyboard.press(this.#random() < 0.7 ? "Enter" : "Escape");
  }

  async #choose(): Promise<void> {
    const choosers = this.lab.page.locator("select:visible:enabled");
    const counts = await choosers.evaluateAll((all) => all.map((one) => (one as HTMLSelectElement).length));
    if (counts.length === 0) return;
    const which = Math.floor(this.#random() * counts.length);
    const index = Math.floor(this.#random() * counts[which]);
    this.done.push(`choose ${index} of ${counts[which]} in chooser ${which}`);
    await quickly(() => choosers.nth(which).selectOption({ index }, { timeout: 1000 }));
  }

  async #undo(): Promise<void> {
    const times = 1 + Math.floor(this.#random() * 4);
    const key = this.#random() < 0.6 ? "Control+z" : "Control+y";
    this.done.push(`${key}, ${times} times`);
    for (let i = 0; i < times; i++) await this.lab.page.keyboard.press(key);
  }
}

/** What hides, is covered or goes away meanwhile is no failure. */
async function quickly(act: () => Promise<unknown>): Promise<void> {
  await act().catch((error: Error) => {
    if (error.name !== "TimeoutError") throw error;
  });
}
