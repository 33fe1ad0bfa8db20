import { formatReading } from "../controls/format";
import type { SceneDocument } from "../family";
import type { StudyPicture } from "../state/study.svelte";
import type { Shape } from "../scene/draw-list";

/** One curve of a plot, a number a step; NaN where there is none. */
export interface PlotLine {
  readonly name: string;
  readonly label: string;
  /** The design token of its colour. */
  readonly token: string;
  readonly mark: Shape | null;
  readonly dash: readonly number[];
  readonly values: Float64Array;
  /** Standard errors of the values, or null where a value is no average. */
  readonly standardErrors: Float64Array | null;
  /** Steps at which a tick is drawn at the floor: something happened. */
  readonly events: readonly number[];
  /** Whether every value is a point of its own, not joined to its neighbours. */
  readonly points?: boolean;
}

/** An edit of the scenario, and what it is called. */
export interface PlotEdit {
  readonly what: string;
  readonly scenario: SceneDocument;
}

/** What a handle in a plot sets. */
export interface Handle {
  /** What a reader calls it. */
  readonly name: string;
  /** What dragging sets. */
  readonly value: number;
  readonly least: number;
  readonly most: number;
  readonly label: string;
  readonly token: string;
  /** The edit that sets another value, and what it is called. */
  edit(value: number): PlotEdit;
}

/** A level that is dragged in the plot itself. */
export interface Threshold extends Handle {
  /** Where the line lies, a number a step, in proportion to the value. */
  readonly heights: Float64Array;
}

/** A place along a plot that is dragged in the plot itself. */
export interface AxisHandle extends Handle {
  /** Where on the axis a value lies, and which value lies there. */
  placeOf(value: number): number;
  valueAt(place: number): number;
}

/** A place along a plot that is worth knowing. */
export interface AxisMark {
  readonly place: number;
  readonly label: string;
}

/** Where values are expected. */
export interface Band {
  readonly low: number;
  readonly high: number;
  readonly label: string;
}

export type ScaleKind = "log" | "linear";

/** What lies along a plot, a number a step, increasing. */
export interface PlotAxis {
  readonly name: string;
  readonly unit: string;
  readonly values: Float64Array;
  readonly scale: ScaleKind;
  /** Whether it is the run's time, along which the timeline's cursor goes. */
  readonly timed: boolean;
  /** Where the scenario lies on it; null for time, and where it lies nowhere. */
  readonly now: number | null;
  readonly handle?: AxisHandle;
  readonly marks?: readonly AxisMark[];
  /** The edit that brings the scenario to another place on it, where a press on the plot does so. */
  edit?(value: number): PlotEdit;
}

export function timeAxis(times: Float64Array): PlotAxis {
  return { name: "time", unit: "s", values: times, scale: "linear", timed: true, now: null };
}

export interface PlotSpec {
  readonly name: string;
  readonly title: string;
  /** Short enough for a button. */
  readonly shortTitle: string;
  readonly unit: string;
  readonly x: PlotAxis;
  readonly lines: readonly PlotLine[];
  readonly bands: readonly Band[];
  readonly threshold: Threshold | null;
  /** The scale it opens with. */
  readonly scale: ScaleKind;
  /** What no value can exceed, such as 100 %; an axis that starts at 0 ends there. */
  readonly ceiling?: number;
  /** A sentence on what the picture leaves out, or null. */
  readonly note: string | null;
  /** Whether it stands above the middle, where curves reach into the right corner. */
  readonly noteInMiddle?: boolean;
}

/** What the numbers of a plot are of. */
export interface PlotSource {
  readonly scenario: SceneDocument;
  /** How many trials were averaged, or null for the one run that is drawn. */
  readonly trials: number | null;
}

/**
 * Where the numbers shown come from. A picture that is not stale is of the scenario at hand even where that says more than
 * was averaged over: a sweep has its own noise, and marks the scenario's.
 */
export function sourceOf(picture: StudyPicture | null, stale: boolean, scenario: SceneDocument): PlotSource {
  if (picture === null) return { scenario, trials: null };
  return { scenario: stale ? picture.scenario : scenario, trials: picture.averages.trials };
}

/** How many standard errors the shaded band of an average reaches to either side. */
export const SPREAD = 2;

export function titleWithUnit({ title, unit }: Pick<PlotSpec, "title" | "unit">): string {
  return withUnit(title, unit);
}

/** Where a step lies: "step 3, 0.300 s" or "size 0.500 m". */
export function placeOf({ x }: Pick<PlotSpec, "x">, step: number): string {
  const place = `${formatReading(x.values[step])} ${x.unit}`.trim();
  return x.timed ? `step ${step + 1}, ${place}` : `${x.name} ${place}`;
}

export function withUnit(name: string, unit: string): string {
  return unit ? `${name} in ${unit}` : name;
}
