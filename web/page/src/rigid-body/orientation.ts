import { DEGREES_PER_RADIAN } from "../controls/format";

/** Orientations as people type them: degrees about the axes, `R = R_z(yaw) R_y(pitch) R_x(roll)`; in the plane one heading. */

type Matrix = readonly (readonly number[])[];

export const ANGLE_NAMES: Record<number, readonly string[]> = { 2: ["heading"], 3: ["roll", "pitch", "yaw"] };

/** Pitch ends where roll and yaw become one. */
export const ANGLE_LIMITS: Record<number, readonly (readonly [number, number])[]> = {
  2: [[-360, 360]],
  3: [
    [-360, 360],
    [-90, 90],
    [-360, 360],
  ],
};

/** Above this cosine of the pitch roll and yaw can be told apart. */
const UPRIGHT = 1e-9;

/** The angles of a rotation in degrees; of another matrix those of the columns that they are read from. */
export function anglesOf(rotation: Matrix): number[] {
  if (rotation.length === 2) return [degrees(Math.atan2(rotation[1][0], rotation[0][0]))];
  const cosine = Math.hypot(rotation[0][0], rotation[1][0]);
  const pitch = degrees(Math.atan2(-rotation[2][0], cosine));
  if (cosine < UPRIGHT) return [0, pitch, degrees(Math.atan2(-rotation[0][1], rotation[1][1]))];
  return [
    degrees(Math.atan2(rotation[2][1], rotation[2][2])),
    pitch,
    degrees(Math.atan2(rotation[1][0], rotation[0][0])),
  ];
}

export function rotationOf(angles: readonly number[]): number[][] {
  const [a, b, c] = angles.map((angle) => angle / DEGREES_PER_RADIAN);
  const [ca, sa] = [Math.cos(a), Math.sin(a)];
  if (angles.length === 1)
    return cleaned([
      [ca, -sa],
      [sa, ca],
    ]);
  const [cb, sb, cc, sc] = [Math.cos(b), Math.sin(b), Math.cos(c), Math.sin(c)];
  return cleaned([
    [cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa],
    [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa],
    [-sb, cb * sa, cb * ca],
  ]);
}

/** `||Q^T Q - I||_F`: 0 for a rotation. */
export function defectOf(matrix: Matrix): number {
  let sum = 0;
  for (let i = 0; i < matrix.length; i++)
    for (let k = 0; k < matrix.length; k++) {
      const dot = matrix.reduce((total, row) => total + row[i] * row[k], 0);
      sum += (dot - (i === k ? 1 : 0)) ** 2;
    }
  return Math.sqrt(sum);
}

/** Right angles give entries like 6e-17 and -0, which JSON and eyes do without. */
function cleaned(matrix: number[][]): number[][] {
  return matrix.map((row) => row.map((entry) => (Math.abs(entry) < 1e-16 ? 0 : entry)));
}

function degrees(angle: number): number {
  return Number((angle * DEGREES_PER_RADIAN).toPrecision(10)) + 0;
}
