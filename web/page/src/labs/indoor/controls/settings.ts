import { DEGREES_PER_RADIAN } from "../../../controls/format";
import type { NumberSetting } from "../../../controls/setting";
import { missing } from "../../../controls/shared-settings";

/** The single numbers of an indoor scenario, as the controls show them. */

export const RATE: NumberSetting = {
  path: "imu.rate_hz",
  label: "IMU rate",
  unit: "Hz",
  scale: { min: 2, max: 100, log: true },
};
export const GYROSCOPE: NumberSetting = {
  path: "imu.gyroscope_density_degrees",
  label: "Gyroscope",
  unit: "°/s/√Hz",
  scale: { min: 1e-4, max: 1, log: true, zero: true },
};
export const ACCELEROMETER: NumberSetting = {
  path: "imu.accelerometer_density_micro_g",
  label: "Accelerometer",
  unit: "µg/√Hz",
  scale: { min: 1, max: 1e5, log: true, zero: true },
};
export const GRAVITY: NumberSetting = { path: "imu.gravity", label: "Gravity", unit: "m/s²", step: 0.1 };

export const RANGE: NumberSetting = {
  path: "ranging.sigma",
  label: "Range σ",
  unit: "m",
  scale: { min: 0.005, max: 2, log: true },
};
export const INTERVAL: NumberSetting = {
  path: "ranging.interval",
  label: "Between fixes",
  unit: "s",
  scale: { min: 0.1, max: 10, log: true },
};
export const MISSING = missing("ranging.missing_probability", "Missing ranges");

export const VARIANCE: NumberSetting = {
  path: "start.prior.variance",
  label: "Variance c",
  unit: "",
  scale: { min: 1e-8, max: 1, log: true },
};
export const ANGLE: NumberSetting = {
  path: "start.prior.angle",
  label: "Angle σ",
  unit: "deg",
  factor: DEGREES_PER_RADIAN,
  scale: { min: 0.01, max: 90, log: true },
};
export const POSITION: NumberSetting = {
  path: "start.prior.position",
  label: "Position σ",
  unit: "m",
  scale: { min: 0.001, max: 10, log: true },
};
export const VELOCITY: NumberSetting = {
  path: "start.prior.velocity",
  label: "Velocity σ",
  unit: "m/s",
  scale: { min: 0.001, max: 10, log: true },
};
