import { DEGREES_PER_RADIAN, formatPoint, formatReading } from "../../controls/format";
import type { IndoorScenario } from "../../generated/IndoorScenario";
import { pointAt, runsAt } from "../../run";
import type { SceneInput } from "../../scene/input";
import { filterOf } from "./filters";
import type { IndoorRun } from "./run";

type Input = SceneInput<IndoorRun, IndoorScenario>;

/** Ranges that were taken at the step shown, and how many were to be; null between fixes. */
function fixAt({ run, step }: Input): { taken: number; all: number } | null {
  if (!run || run.fixes[step] !== 1) return null;
  const all = 3 * run.anchors.length;
  const here = run.present.subarray(step * all, (step + 1) * all);
  return { taken: here.reduce((sum, one) => sum + one, 0), all };
}

/** How to read the lines of the scene. */
export function note(input: Input): string {
  if (!input.run) return "";
  const fix = fixAt(input);
  if (!fix) return "No ranges at this step: the IMU alone";
  return fix.taken === fix.all
    ? ""
    : `${fix.all - fix.taken} of ${fix.all} ranges missing at this step: dashed`;
}

/** The scene in words. */
export function told(input: Input): string[] {
  const { run, step } = input;
  if (!run) return [];
  const fix = fixAt(input);
  return [
    fix
      ? `${fix.taken} of ${fix.all} ranges are measured at this step.`
      : "No ranges are taken at this step.",
    ...run.filters.map((filter) => {
      const { label } = filterOf(filter.name);
      if (!runsAt(filter, step)) return `${label} has stopped.`;
      const place = pointAt(filter.positions, step, 3).map((value) => Number(value.toPrecision(4)));
      const degrees = formatReading(filter.orientationErrors[step] * DEGREES_PER_RADIAN);
      const metres = formatReading(filter.positionErrors[step]);
      return `${label} at ${formatPoint(place)}, ${metres} m and ${degrees} degrees from the body.`;
    }),
  ];
}
