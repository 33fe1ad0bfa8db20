import type { Component } from "svelte";
import type { Run } from "./run";
import type { Scenario } from "./scenario";
import type { View } from "./scene/camera";
import type { DrawList, Shape } from "./scene/draw-list";
import type { Frame } from "./scene/frame";
import type { Vec3 } from "./scene/geometry";
import type { Palette } from "./theme/palette";

/** Everything a layer of the scene may look at. */
export interface SceneInput {
  readonly scenario: Scenario;
  readonly run: Run | null;
  readonly step: number;
  readonly frame: Frame;
  readonly view: View;
  readonly palette: Palette;
  readonly selectedAnchor: number | null;
  readonly hoveredAnchor: number | null;
}

/** Adds its shapes to the picture. */
export type Layer = (input: SceneInput, out: DrawList) => void;

/** A text that stays beside a point of the scene. */
export interface Label {
  readonly at: Vec3;
  readonly text: string;
  readonly kind: "anchor" | "tick" | "axis";
  readonly strong?: boolean;
}

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

/** A lab plugs into the frame: what it draws, plots, says and lets one change. */
export interface Lab {
  readonly name: string;
  readonly title: string;
  readonly layers: readonly Layer[];
  labels(input: SceneInput): Label[];
  plots(scenario: Scenario, run: Run): PlotSpec[];
  /** One sentence on what the run shows. */
  describe(run: Run): string;
  readonly Controls: Component;
  readonly Readout: Component;
}
