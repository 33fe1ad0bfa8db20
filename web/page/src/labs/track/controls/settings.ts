import { DEGREES_PER_RADIAN } from "../../../controls/format";
import type { NumberSetting } from "../../../controls/setting";
import { missing } from "../../../controls/shared-settings";

/** The single numbers of a scenario, as the controls show them. */

export const MISSING = missing("missing_probability", "Missing ranges");

export const EPSILON: NumberSetting = {
  path: "estimators.threshold.epsilon",
  label: "ET threshold ε",
  unit: "",
  scale: { min: 0.001, max: 3, log: true, zero: true },
};

export const STEPS: NumberSetting = { path: "steps", label: "Steps", unit: "", step: 10, min: 1 };
export const INTERVAL: NumberSetting = { path: "interval", label: "Interval", unit: "s", step: 0.1 };

/** How unsteadily the body really moves. */
export const DISTURBANCES: readonly NumberSetting[] = [
  angleNoise("motion.sigma_omega", "Turn rate σ_ω", "deg/s"),
  positionNoise("motion.sigma_t", "Shift per step σ_t"),
];

/** How unsteadily the filters take it to move. */
export const PROCESS_NOISE: readonly NumberSetting[] = [
  angleNoise("process.sigma_q", "Turn per step σ_q", "deg"),
  positionNoise("process.sigma_t", "Shift per step σ_t"),
];

export const PRIOR_VARIANCE: NumberSetting = {
  path: "initial.covariance",
  label: "Variance",
  unit: "",
  scale: { min: 1e-4, max: 1e4, log: true },
};

function angleNoise(path: string, label: string, unit: string): NumberSetting {
  const scale = { min: 0.003, max: 30, log: true, zero: true };
  return { path, label, unit, factor: DEGREES_PER_RADIAN, scale };
}

function positionNoise(path: string, label: string): NumberSetting {
  return { path, label, unit: "m", scale: { min: 0.001, max: 10, log: true, zero: true } };
}

export const RADIUS: NumberSetting = {
  path: "motion.path.radius",
  label: "Radius",
  unit: "m",
  scale: { min: 0.05, max: 1000, log: true },
};
export const PERIOD: NumberSetting = {
  path: "motion.path.period",
  label: "Period",
  unit: "s",
  scale: { min: 0.1, max: 1000, log: true },
};
export const CLIMB: NumberSetting = { path: "motion.path.climb", label: "Climb a turn", unit: "m" };
