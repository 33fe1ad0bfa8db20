/** Puts what comes in any order back into the order of its numbers, 0, 1, 2, … */
export class InOrder<T> {
  #next = 0;
  readonly #early = new Map<number, T>();

  /** What has its turn now that `value` is there: nothing, it alone, or it and what waited for it. */
  accept(index: number, value: T): T[] {
    this.#early.set(index, value);
    const ready: T[] = [];
    for (; this.#early.has(this.#next); this.#next++) {
      ready.push(this.#early.get(this.#next)!);
      this.#early.delete(this.#next);
    }
    return ready;
  }
}
