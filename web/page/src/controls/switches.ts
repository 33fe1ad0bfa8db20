import type { PlotLine } from "../plots/spec";
import type { Shape } from "../scene/draw-list";

/** An estimator that is switched on and off: how it looks, and what it is in a few words. */
export interface Switch<Name extends string> extends Pick<PlotLine, "label" | "token"> {
  readonly name: Name;
  readonly meaning: string;
  readonly mark: Shape;
  readonly dash?: readonly number[];
}

export interface SwitchGroup<Entry extends Switch<string>> {
  readonly title?: string;
  readonly entries: readonly Entry[];
}
