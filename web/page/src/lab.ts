import type { Component } from "svelte";
import type { PlotSpec } from "./plots/spec";
import type { Run } from "./run";
import type { Scenario } from "./scenario";
import type { Label, Layer, SceneInput } from "./scene/input";

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
