import type { Shape } from "../scene/draw-list";

export interface PlotLine {
  readonly name: string;
  readonly label: string;
  /** The design token of its colour. */
  readonly token: string;
  readonly mark: Shape | null;
  readonly dash: readonly number[];
  readonly values: readonly (number | null)[];
  /** Steps at which a filled mark is drawn: something happened. */
  readonly events: readonly number[];
}

export interface PlotSpec {
  readonly name: string;
  readonly title: string;
  readonly unit: string;
  /** Seconds. */
  readonly times: Float64Array;
  readonly lines: readonly PlotLine[];
  readonly threshold: { readonly value: number; readonly label: string } | null;
}
