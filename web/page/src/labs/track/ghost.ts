import type { Scenario } from "../../scenario";
import type { Run } from "../../run";
import type { Layer } from "../../scene/input";
import { drawnSensors, hullOfSensors } from "../../rigid-body/drawn";

/** Where the body truly is at the step under the pointer in a plot. */
export const ghost: Layer<Run, Scenario> = (input, out) => {
  const { run, pointedStep, palette, scenario } = input;
  if (!run || pointedStep === null) return;
  const sensors = drawnSensors(input, run, run.truth, pointedStep);
  const color = palette.rgba("truth", 0.6);
  for (const [i, j] of hullOfSensors(scenario.sensors).edges)
    out.line(sensors[i], sensors[j], { width: 1.5, dash: 5, color });
  for (const sensor of sensors) out.point(sensor, 3, color, "ring");
};
