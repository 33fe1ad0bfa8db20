/** Undo and redo over immutable states. A gesture (a drag, a moving slider) previews many states and is one entry. */
export class History<T> {
  #past: T[] = [];
  #present: T;
  #future: T[] = [];
  #gestureStart: T | undefined;
  readonly #depth: number;

  constructor(present: T, depth = 500) {
    this.#present = present;
    this.#depth = depth;
  }

  get present(): T {
    return this.#present;
  }

  get canUndo(): boolean {
    return this.#past.length > 0 || this.#gestureStart !== undefined;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** The state that redo would bring back. */
  get next(): T | undefined {
    return this.#future.at(-1);
  }

  /** Whether a gesture is going on. */
  get inGesture(): boolean {
    return this.#gestureStart !== undefined;
  }

  /** Shows a state without an entry of its own; the first preview opens a gesture. */
  preview(next: T): void {
    this.#gestureStart ??= this.#present;
    this.#present = next;
  }

  /** Ends the gesture: what it started from becomes one entry. */
  commit(): void {
    if (this.#gestureStart === undefined) return;
    this.#past.push(this.#gestureStart);
    if (this.#past.length > this.#depth) this.#past.shift();
    this.#future = [];
    this.#gestureStart = undefined;
  }

  /** Ends the gesture and goes back to where it started. */
  cancel(): void {
    if (this.#gestureStart === undefined) return;
    this.#present = this.#gestureStart;
    this.#gestureStart = undefined;
  }

  /** Goes back to the state before the last entry, or before the gesture, and forgets what it led to. */
  discard(): void {
    if (this.inGesture) return this.cancel();
    this.#present = this.#past.pop() ?? this.#present;
  }

  edit(next: T): void {
    this.commit();
    this.preview(next);
    this.commit();
  }

  /** Takes back the last edit and returns the state it had made, or undefined at the beginning. */
  undo(): T | undefined {
    this.commit();
    const previous = this.#past.pop();
    if (previous === undefined) return undefined;
    const undone = this.#present;
    this.#future.push(undone);
    this.#present = previous;
    return undone;
  }

  /** Makes the last undone edit again and returns the state it makes, or undefined where there is none. */
  redo(): T | undefined {
    this.commit();
    const next = this.#future.pop();
    if (next === undefined) return undefined;
    this.#past.push(this.#present);
    this.#present = next;
    return next;
  }
}
