import { fieldProbe } from "../../engine";
import type { FieldLayout } from "../../generated/FieldLayout";
import type { PointBound } from "../../generated/PointBound";
import type { Scenario } from "../../scenario";
import { cross, dot, scale, sub, type Vec3 } from "../../scene/geometry";
import type { Ray } from "../../scene/view";

/** The typed place at which the field is read, besides the one under the pointer. */
class Probe {
  #typed: readonly number[] | null = $state.raw(null);

  /** By default where the body is. */
  typed({ dimension, start }: Scenario): readonly number[] {
    return this.#typed?.length === dimension ? this.#typed : start.position;
  }

  type(point: readonly number[] | null): void {
    this.#typed = point;
  }
}

export const probe = new Probe();

/** The bounds at a point; null where the engine has none to tell, as at an anchor. */
export function boundsAt(scenario: Scenario, point: readonly number[]): PointBound | null {
  try {
    return fieldProbe(scenario, point);
  } catch {
    return null;
  }
}

/** The point of the field that a ray meets; null beside the field, and where it is seen edge-on. */
export function pointUnder(ray: Ray | null, field: FieldLayout | null, dimension: number): number[] | null {
  if (ray === null || field === null) return null;
  const { corner, u, v } = field;
  const normal = cross(u, v);
  const along = dot(sub(corner, ray.origin), normal) / dot(ray.direction, normal);
  if (!(along > 0) || !Number.isFinite(along)) return null;
  const at = sub(shiftedBy(ray, along), corner);
  const inside = (edge: Vec3) => dot(at, edge) >= 0 && dot(at, edge) <= dot(edge, edge);
  return inside(u) && inside(v) ? shiftedBy(ray, along).slice(0, dimension) : null;
}

function shiftedBy({ origin, direction }: Ray, along: number): [number, number, number] {
  const [x, y, z] = scale(direction, along);
  return [origin[0] + x, origin[1] + y, origin[2] + z];
}
