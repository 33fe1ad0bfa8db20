import type { MotionRecord } from "../../generated/MotionRecord";
import { add, cross, length, niceBelow, normalize, scale, type Vec3 } from "../../scene/geometry";

/** How the body is drawn that has moved along a motion the ranges see least. */

export interface Motion {
  /** Turned by this rotation vector in the body frame, rad, then shifted in the world, m. */
  readonly rotation: Vec3;
  readonly shift: Vec3;
  /** How many times larger than one standard deviation it is; null where the motion is not seen at all. */
  readonly times: number | null;
}

/** Shares of the body's radius that sensors move by: less is not seen, and one that is not seen at all moves by the other. */
const LEAST = 0.25;
const UNSEEN = 0.6;
/** No ghost turns or goes farther than this, rad and m. */
const FARTHEST_TURN = Math.PI / 3;

/** One standard deviation along the mode, larger by a round number where it would not be seen; `reach` is the farthest shift. */
export function motionOf(mode: MotionRecord, bodyRadius: number, reach: number): Motion {
  const { standard_deviation: deviation } = mode;
  const times = deviation === null ? null : magnified(deviation, LEAST * bodyRadius);
  const size = deviation === null ? UNSEEN * bodyRadius : deviation * times!;
  const rotation = asVector(mode.rotation, true);
  const shift = asVector(mode.shift, false);
  const most = Math.min(
    size,
    FARTHEST_TURN / Math.max(1e-300, length(rotation)),
    reach / Math.max(1e-300, length(shift)),
  );
  return { rotation: scale(rotation, most), shift: scale(shift, most), times };
}

function magnified(deviation: number, least: number): number {
  return deviation >= least ? 1 : Math.max(1, niceBelow((2 * least) / Math.max(deviation, 1e-12)));
}

/** Motions of the plane turn about z. */
function asVector(values: readonly number[], turn: boolean): Vec3 {
  if (values.length === 3) return [values[0], values[1], values[2]];
  return turn ? [0, 0, values[0]] : [values[0], values[1], 0];
}

/** A vector turned by a rotation vector (Rodrigues). */
export function turned(vector: Vec3, rotation: Vec3): Vec3 {
  const angle = length(rotation);
  const axis = normalize(rotation);
  const along = axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
  return add(
    add(scale(vector, Math.cos(angle)), scale(cross(axis, vector), Math.sin(angle))),
    scale(axis, along * (1 - Math.cos(angle))),
  );
}
