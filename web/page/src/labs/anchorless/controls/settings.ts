import type { NumberSetting } from "../../../controls/setting";
import { missing } from "../../../controls/shared-settings";

/** The single numbers of a kinematics scenario, as the controls show them. */

export const COUNT: NumberSetting = {
  path: "stamps.count",
  label: "Stamps K",
  unit: "",
  step: 1,
  min: 1,
  whole: true,
  scale: { min: 5, max: 1000, log: true },
};
export const FIRST: NumberSetting = { path: "stamps.first", label: "First", unit: "s", step: 0.5 };
export const LAST: NumberSetting = { path: "stamps.last", label: "Last", unit: "s", step: 0.5 };
export const STEPS: NumberSetting = {
  path: "steps",
  label: "Steps played",
  unit: "",
  step: 10,
  min: 1,
};

export const DISTANCE: NumberSetting = {
  path: "noise.sigma_distance",
  label: "Distance σ_d",
  unit: "m",
  scale: { min: 1e-4, max: 10, log: true, zero: true },
};
export const ACCELERATION: NumberSetting = {
  path: "noise.sigma_acceleration",
  label: "Acceleration σ_a",
  unit: "m/s²",
  scale: { min: 1e-5, max: 1, log: true, zero: true },
};
export const MISSING = missing("noise.missing_probability", "Missing distances");

export const DEGREE: NumberSetting = {
  path: "estimators.degree",
  label: "Degree L assumed",
  unit: "",
  step: 1,
  min: 0,
  max: 8,
};
export const RANGE_DEGREE: NumberSetting = {
  path: "estimators.range_degree",
  label: "Degree q of a range",
  unit: "",
  step: 1,
  min: 2,
  max: 16,
};
