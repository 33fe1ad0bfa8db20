import { getContext, setContext } from "svelte";
import type { SceneDocument } from "../family";
import type { LabRun } from "../lab";
import { differsAt, valueAt, withValue } from "./path";
import type { Session } from "./session.svelte";

/** The values of the scenario as controls show and change them: by path, beside those of the preset. */
export class Editing<S extends SceneDocument = SceneDocument> {
  readonly #session: Session<LabRun, S>;
  readonly #name = $derived.by(() => this.#session.scenario.name);
  /** The preset that the scenario started from: what values are reset to. Null for a scenario of one's own. */
  readonly reference: S | null = $derived.by(() => {
    const { lab } = this.#session;
    return lab.presets().some((entry) => entry.name === this.#name) ? (lab.preset(this.#name) as S) : null;
  });

  constructor(session: Session<LabRun, S>) {
    this.#session = session;
  }

  get scenario(): S {
    return this.#session.scenario;
  }

  /** Why the last edit was refused. */
  get refusal(): string | null {
    return this.#session.refusal;
  }

  number(path: string): number {
    return valueAt(this.scenario, path) as number;
  }

  /** Part of an edit in progress, such as a slider in motion. */
  preview(what: string, path: string, value: unknown): void {
    this.#session.preview(what, withValue(this.scenario, path, value));
  }

  edit(what: string, path: string, value: unknown): boolean {
    return this.apply(what, withValue(this.scenario, path, value));
  }

  apply(what: string, next: S): boolean {
    return this.#session.edit(what, next);
  }

  /** Tells of something typed that is no value at all. */
  refuse(sentence: string): void {
    this.#session.refusal = sentence;
  }

  changed(paths: readonly string[]): boolean {
    return this.reference !== null && differsAt(this.scenario, this.reference, paths);
  }

  /** What a value is in the preset; undefined without one. */
  original(path: string): unknown {
    return this.reference === null ? undefined : valueAt(this.reference, path);
  }

  reset(what: string, paths: readonly string[]): void {
    const { reference } = this;
    if (reference === null) return;
    const back = (next: S, path: string) => withValue(next, path, valueAt(reference, path));
    this.apply(`${what} reset`, paths.reduce(back, this.scenario));
  }
}

const KEY = Symbol("editing");

export function provideEditing(session: Session): Editing {
  return setContext(KEY, new Editing(session));
}

/** A lab's own controls know what its documents are: `useEditing<Scenario>()`. */
export function useEditing<S extends SceneDocument = SceneDocument>(): Editing<S> {
  return getContext(KEY);
}
