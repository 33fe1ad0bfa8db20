import type { Room, SceneDocument } from "../family";
import type { LabRun } from "../lab";
import type { Handle } from "../state/handles";
import type { Thing } from "../state/things";
import type { Palette } from "../theme/palette";
import type { DrawList } from "./draw-list";
import type { Frame } from "./frame";
import type { Vec3 } from "./geometry";
import type { Pixel, Ray, View } from "./view";

/** Which uncertainty is drawn: ellipsoids of the position, fans of the axes. */
export interface UncertaintyShown {
  readonly position: boolean;
  readonly orientation: boolean;
}

/** Everything a layer of the scene may look at. */
export interface SceneInput<R extends LabRun = LabRun, S extends SceneDocument = SceneDocument> {
  readonly scenario: S;
  readonly room: Room;
  readonly run: R | null;
  readonly step: number;
  /** The step under the pointer in a plot, or null. */
  readonly pointedStep: number | null;
  readonly frame: Frame;
  readonly view: View;
  readonly palette: Palette;
  /** What can be moved beside the anchors. */
  readonly handles: readonly Handle[];
  readonly selected: readonly Thing[];
  /** Where what was chosen last is, while the triangle that lifts it shows. */
  readonly lifted: Vec3 | null;
  readonly hovered: Thing | null;
  readonly uncertainty: UncertaintyShown;
  /** The line of sight through the pointer, followed where the lab has a field to read; else null. */
  readonly ray: Ray | null;
}

/** Adds its shapes to the picture. */
export type Layer<R extends LabRun = LabRun, S extends SceneDocument = SceneDocument> = (
  input: SceneInput<R, S>,
  out: DrawList,
) => void;

/** A text that stays beside a point of the scene. */
export interface Label {
  /** The same from picture to picture. */
  readonly id: string;
  readonly at: Vec3;
  readonly text: string;
  readonly kind: "anchor" | "handle" | "axis" | "name" | "tick";
  readonly strong?: boolean;
  /** CSS pixels from the point to the middle of the text, where one place is better than the others. */
  readonly offset?: Pixel;
  /** Other points that the text may stand at where there is no place at the first. */
  readonly elsewhere?: readonly Vec3[];
}
