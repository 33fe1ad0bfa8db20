import { getContext, setContext } from "svelte";
import { keep, recall } from "../state/storage";
import type { PlotSpec, ScaleKind } from "./spec";

interface Choices {
  /** Plots that are left out. */
  hidden: string[];
  scales: Record<string, ScaleKind>;
}

/** What the reader chose to see of the plots; remembered from visit to visit. */
export class PlotsView {
  /** The plot that has all the room, or null. */
  enlarged: string | null = $state(null);
  #choices: Choices = $state({ hidden: [], scales: {} });
  /** The latest choice last: where room is short, it is shown. */
  #recent: string[] = $state([]);

  /** `stored` is where the choices are remembered; `emphasizes` says whether the lab's estimator stands out in them. */
  constructor(
    private readonly stored = "plots",
    readonly emphasizes = true,
  ) {
    this.#choices = readChoices(stored);
  }

  scaleOf(spec: PlotSpec): ScaleKind {
    return this.#choices.scales[spec.name] ?? spec.scale;
  }

  setScale(name: string, scale: ScaleKind): void {
    this.#choices.scales[name] = scale;
    this.#store();
  }

  /** The plots that the reader wants, whether there is room or not. */
  wanted(specs: readonly PlotSpec[]): PlotSpec[] {
    const kept = specs.filter((spec) => !this.#choices.hidden.includes(spec.name));
    return kept.length > 0 ? kept : specs.slice(0, 1);
  }

  /** The wanted plots there is room for, in their usual order. */
  shown(specs: readonly PlotSpec[], count: number): PlotSpec[] {
    const wanted = this.wanted(specs);
    const rank = (spec: PlotSpec) => this.#recent.indexOf(spec.name);
    const first = wanted.toSorted((a, b) => rank(b) - rank(a)).slice(0, count);
    return wanted.filter((spec) => first.includes(spec));
  }

  /** A shown plot goes; another one comes, in the place of one chosen before where room is short. */
  toggle(name: string, isShown: boolean): void {
    const others = (list: string[]) => list.filter((entry) => entry !== name);
    this.#choices.hidden = isShown ? [...others(this.#choices.hidden), name] : others(this.#choices.hidden);
    this.#recent = isShown ? others(this.#recent) : [...others(this.#recent), name];
    this.#store();
  }

  #store(): void {
    keep(this.stored, JSON.stringify(this.#choices));
  }
}

/** What was stored by hand or by an older page may be anything. */
function readChoices(key: string): Choices {
  try {
    const stored = JSON.parse(recall(key) ?? "{}") as Partial<Choices>;
    const hidden = Array.isArray(stored.hidden) ? stored.hidden : [];
    const scales = Object.entries(stored.scales ?? {}).filter(
      ([, scale]) => scale === "log" || scale === "linear",
    );
    return { hidden, scales: Object.fromEntries(scales) };
  } catch {
    return { hidden: [], scales: {} };
  }
}

const KEY = Symbol("plots");

export function providePlotsView(view: PlotsView): PlotsView {
  return setContext(KEY, view);
}

export function usePlotsView(): PlotsView {
  return getContext(KEY);
}
