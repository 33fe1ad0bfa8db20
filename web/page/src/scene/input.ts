import type { LabRun } from "../lab";
import type { Scenario } from "../scenario";
import type { Palette } from "../theme/palette";
import type { View } from "./camera";
import type { DrawList } from "./draw-list";
import type { Frame } from "./frame";
import type { Vec3 } from "./geometry";

/** Everything a layer of the scene may look at. */
export interface SceneInput<R extends LabRun = LabRun> {
  readonly scenario: Scenario;
  readonly run: R | null;
  readonly step: number;
  readonly frame: Frame;
  readonly view: View;
  readonly palette: Palette;
  readonly selectedAnchor: number | null;
  readonly hoveredAnchor: number | null;
}

/** Adds its shapes to the picture. */
export type Layer<R extends LabRun = LabRun> = (input: SceneInput<R>, out: DrawList) => void;

/** A text that stays beside a point of the scene. */
export interface Label {
  readonly at: Vec3;
  readonly text: string;
  readonly kind: "anchor" | "tick" | "axis";
  readonly strong?: boolean;
}
