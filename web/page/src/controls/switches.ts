import type { PlotLine } from "../plots/spec";

/** An estimator that is switched on and off: how it looks, and what it is in a few words. */
export interface Switch<Name extends string> extends Pick<PlotLine, "label" | "token" | "mark"> {
  readonly name: Name;
  readonly meaning: string;
  readonly dash?: readonly number[];
}

export interface SwitchGroup<Name extends string> {
  readonly title?: string;
  readonly entries: readonly Switch<Name>[];
}
