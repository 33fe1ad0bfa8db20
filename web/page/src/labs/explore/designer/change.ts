import { DEGREES_PER_RADIAN, formatReading } from "../../../controls/format";
import type { PointBound } from "../../../generated/PointBound";

/** What a change of the body does to its bounds. */

/** Root of the trace of the bound on the position (m) and on the angles (rad); null where there is none. */
export type Bounds = Pick<PointBound, "position_sigma" | "angle_sigma">;

/** Below this nothing has changed but roundings. */
const SAME = 5e-4;

/** "14 % better": how a bound is now against before. */
export function compared(now: number | null, before: number | null): string {
  if (now === null) return before === null ? "none" : "lost";
  if (before === null) return "new";
  const share = Math.abs(now / before - 1);
  if (share < SAME) return "the same";
  const digits = share < 0.095 ? 1 : 0;
  // So much larger a bound is told as a factor: percentages of that size say nothing.
  if (now >= 3 * before) return `${formatReading(now / before)} × worse`;
  return `${(100 * share).toFixed(digits)} % ${now < before ? "better" : "worse"}`;
}

export interface BoundRow {
  readonly name: "orientation" | "position";
  readonly unit: string;
  readonly now: string;
  readonly change: string;
}

/** Both bounds as the read-out shows them; without `before` nothing is compared. */
export function boundRows(now: Bounds, before: Bounds | null): BoundRow[] {
  return [
    row("orientation", "deg", DEGREES_PER_RADIAN, now.angle_sigma, before && { value: before.angle_sigma }),
    row("position", "m", 1, now.position_sigma, before && { value: before.position_sigma }),
  ];
}

function row(
  name: BoundRow["name"],
  unit: string,
  factor: number,
  now: number | null,
  before: { value: number | null } | null,
): BoundRow {
  const shown = formatReading(now === null ? null : now * factor);
  return { name, unit, now: shown, change: before ? compared(now, before.value) : "" };
}

/** "Orientation bound 1.21 deg, 14 % better; position bound 0.0120 m, the same." */
export function toldRows(rows: readonly BoundRow[]): string {
  const told = rows.map(({ name, unit, now, change }) => {
    const value = now === "–" ? "does not exist" : `${now} ${unit}`;
    return `${name} bound ${value}${change ? `, ${change}` : ""}`;
  });
  const sentence = told.join("; ");
  return `${sentence[0].toUpperCase()}${sentence.slice(1)}.`;
}
