import type { SnapshotBoundFigures } from "../../generated/SnapshotBoundFigures";
import type { PlotLine } from "../../plots/spec";
import { formatReading } from "../../controls/format";
import { BOUND_LOOKS, boundOf, boundsFor, lookOf } from "./localizers";
import type { LocalizeRun } from "./run";

/** A row of the table of errors, with the look that it has everywhere; null where there is no such number. */
export interface Reading extends Pick<PlotLine, "name" | "label" | "token" | "mark" | "dash"> {
  /** rad */
  readonly angle: number | null;
  /** m */
  readonly position: number | null;
  /** Share of the trials in which the body is mirrored. */
  readonly reflections: number | null;
  readonly iterations: number | null;
  /** What more there is to know of the row. */
  readonly remark: string;
}

/** The errors in the trial drawn, or root mean square errors over the cloud. */
export type Of = "trial" | "cloud";

export function localizerReadings(run: LocalizeRun, of: Of): Reading[] {
  return of === "trial" ? trialReadings(run) : cloudReadings(run);
}

function trialReadings({ snapshot }: LocalizeRun): Reading[] {
  return snapshot.estimators.map(({ name, errors, reflected, iterations, failure, sensors_error }) => ({
    ...lookOf(name),
    dash: [],
    angle: errors?.angle ?? null,
    position: errors?.position ?? null,
    reflections: errors ? Number(reflected) : null,
    iterations: failure === null ? iterations : null,
    remark: failure ?? `Sensors: ${formatReading(sensors_error)} m off, all together`,
  }));
}

function cloudReadings({ report }: LocalizeRun): Reading[] {
  return report.estimators.map(({ name, points: [summary] }) => {
    const { trials, failures } = summary;
    return {
      ...lookOf(name),
      dash: [],
      angle: summary.rms_angle?.value ?? null,
      position: summary.rmse_position?.value ?? null,
      reflections: summary.reflection_rate?.value ?? null,
      iterations: trials > 0 ? summary.iterations.value : null,
      remark:
        failures > 0 ? `No estimate in ${failures} of ${report.trials} trials` : againstBound(name, report),
    };
  });
}

export function boundReadings({ snapshot, report }: LocalizeRun, of: Of): Reading[] {
  const found = of === "trial" ? snapshot.bounds : report.bounds.map(averaged);
  return boundsFor(snapshot.estimators.map(({ name }) => name))
    .flatMap((wanted) => found.filter(({ name }) => name === wanted))
    .map(({ name, label, angle, position }) => ({
      name,
      ...BOUND_LOOKS[name],
      token: "bound",
      mark: null,
      angle,
      position,
      reflections: null,
      iterations: null,
      remark: label,
    }));
}

function averaged({ name, label, points: [point] }: LocalizeRun["report"]["bounds"][number]) {
  const value = (figure: keyof Pick<SnapshotBoundFigures, "angle" | "position">) =>
    point[figure]?.value ?? null;
  return { name, label, angle: value("angle"), position: value("position") };
}

/** "1.04 times the UC-CRB in orientation, 1.01 times in position": with the bound for what the localizer knows. */
function againstBound(
  name: LocalizeRun["report"]["estimators"][number]["name"],
  report: LocalizeRun["report"],
): string {
  const mine = report.estimators.find((entry) => entry.name === name)?.points[0];
  const bound = report.bounds.find((entry) => entry.name === boundOf(name));
  if (!mine || !bound) return "";
  const [least] = bound.points;
  const { label } = BOUND_LOOKS[bound.name];
  const ratio = (error: { value: number } | null, limit: { value: number } | null) =>
    error && limit && limit.value > 0 ? formatReading(error.value / limit.value) : null;
  const parts = [
    ["orientation", ratio(mine.rms_angle, least.angle)],
    ["position", ratio(mine.rmse_position, least.position)],
    ["sensors", mine.rms_angle ? null : ratio(mine.rmse_sensors, least.sensors)],
  ].flatMap(([what, times]) => (times === null ? [] : [`${times} × in ${what}`]));
  return parts.length === 0 ? "" : `Against ${label}: ${parts.join(", ")}`;
}
