import type { EstimatorName } from "./generated/EstimatorName";

/** The documents as the page names them; the types themselves are written by the crate. */
export type { EstimatorName } from "./generated/EstimatorName";
export type { EstimatorSettings } from "./generated/EstimatorSettings";
export type { NamedTopology } from "./generated/NamedTopology";
export type { PathSettings } from "./generated/PathSettings";
export type { RangeNoise } from "./generated/RangeNoise";
export type { Scenario } from "./generated/Scenario";

/** What each estimator is, in a few words, in the order the page lists them. */
export const ESTIMATORS: readonly { name: EstimatorName; label: string; meaning: string }[] = [
  { name: "kf", label: "KF", meaning: "Kalman filter, no constraint" },
  { name: "ortho", label: "KF-ortho", meaning: "projected every step" },
  { name: "uc-kf", label: "UC-KF", meaning: "unitarily constrained" },
  { name: "et-kf", label: "ET-KF", meaning: "projected beyond ε" },
  { name: "eskf", label: "ESKF", meaning: "error-state, on rotations" },
  { name: "eskf-raw", label: "ESKF raw", meaning: "on squared ranges" },
];
