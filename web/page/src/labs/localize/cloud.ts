import { localizationCloud } from "../../engine";
import type { LocalizerName } from "../../generated/LocalizerName";
import type { PoseTrack } from "../../run";
import type { Scenario } from "../../scenario";

/** What one localizer found in many trials, each as seen from that trial's truth; trials without a pose are left out. */
export interface Cloud {
  readonly name: LocalizerName;
  readonly count: number;
  /** `t_hat - t`: count x D, m. */
  readonly moved: Float64Array;
  /** `Q_hat Q^T`, row by row: count x D x D. */
  readonly turned: Float64Array;
  /** Which of them mirrors the body. */
  readonly mirrored: readonly boolean[];
}

/** The clouds of trials `0..trials`, one a localizer. */
export function cloudsOf(scenario: Scenario, trials: number): Cloud[] {
  const { dimension, localize } = scenario;
  const stride = 3 + dimension * (dimension + 1);
  const numbers = localizationCloud(scenario, trials);
  return localize.enabled.map((name, index) => {
    const rows = Array.from({ length: trials }, (_, trial) => {
      const at = (trial * localize.enabled.length + index) * stride;
      return numbers.subarray(at, at + stride);
    }).filter(([there]) => there === 1);
    const split = 3 + dimension * dimension;
    return {
      name,
      count: rows.length,
      moved: joined(rows.map((row) => row.subarray(split))),
      turned: joined(rows.map((row) => row.subarray(3, split))),
      mirrored: rows.map(([, mirrored]) => mirrored === 1),
    };
  });
}

/** One of the estimates, as if the body were at `truth`. */
export function poseIn(cloud: Cloud, index: number, truth: PoseTrack, dimension: number): PoseTrack {
  const [moved, turned] = [cloud.moved, cloud.turned];
  const at = index * dimension * dimension;
  const entry = (row: number, column: number) => {
    let sum = 0;
    for (let k = 0; k < dimension; k++)
      sum += turned[at + row * dimension + k] * truth.orientations[k * dimension + column];
    return sum;
  };
  return {
    positions: truth.positions.map((value, axis) => value + moved[index * dimension + axis]),
    orientations: truth.orientations.map((_, i) => entry(Math.floor(i / dimension), i % dimension)),
  };
}

function joined(rows: readonly Float64Array[]): Float64Array {
  const all = new Float64Array(rows.length * (rows[0]?.length ?? 0));
  rows.forEach((row, index) => all.set(row, index * row.length));
  return all;
}
