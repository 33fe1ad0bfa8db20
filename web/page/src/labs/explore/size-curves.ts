import { DEGREES_PER_RADIAN } from "../../controls/format";
import { sizeCurve } from "../../engine";
import type { RangeForm } from "../../generated/RangeForm";
import { sizeOf } from "../../rigid-body/topologies";
import type { Scenario } from "../../scenario";

/** The bound on the orientation against the size of the body, by projected and by raw ranges. */
export interface SizeCurves {
  /** Largest distance between two sensors, m; 0 for a single one. */
  readonly size: number;
  /** Sizes of the same body, m, increasing; its own is among them. */
  readonly sizes: Float64Array;
  /** deg; NaN where there is no bound. */
  readonly projected: Float64Array;
  readonly raw: Float64Array;
}

/** From a thousandth of the scene to all of it. */
const DECADES = 3;
const POINTS_PER_DECADE = 12;
/** With more ranges than this a point takes so long that a drag would stutter: then there are fewer of them. */
const MANY_RANGES = 2000;
const FEWER_PER_DECADE = 3;
export function sizeCurves(scenario: Scenario): SizeCurves {
  const { anchors, sensors, field } = scenario;
  const size = sizeOf(sensors);
  const many = anchors.length * sensors.length > MANY_RANGES;
  const sizes = sizesAround(size, extentOf(anchors), many ? FEWER_PER_DECADE : POINTS_PER_DECADE);
  const scales = sizes.map((value) => value / size);
  const bounds = (form: RangeForm) =>
    size > 0
      ? sizeCurve({ ...scenario, field: { ...field, form } }, scales).map(
          (bound) => bound * DEGREES_PER_RADIAN,
        )
      : sizes.map(() => NaN);
  return { size, sizes, projected: bounds("projected"), raw: bounds("raw") };
}

/** Even steps on a logarithmic scale that hold the size itself, over whole decades of the scene. */
export function sizesAround(size: number, extent: number, perDecade: number): Float64Array {
  const top = Math.ceil(Math.log10(extent) - 1e-9);
  const own = size > 0 ? Math.log10(size) : top;
  const [low, high] = [Math.min(top - DECADES, Math.floor(own)), Math.max(top, Math.ceil(own))];
  const count = (high - low) * perDecade;
  const steps = Array.from({ length: count + 1 }, (_, k) => 10 ** (low + k / perDecade));
  const others = steps.filter((step) => Math.abs(Math.log(step / size)) > 1e-6);
  return Float64Array.from(size > 0 ? [...others, size] : steps).sort();
}

function extentOf(anchors: Scenario["anchors"]): number {
  const sides = anchors[0].map((_, axis) => {
    const values = anchors.map((anchor) => anchor[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.max(...sides) || 1;
}
