/** The documents as the page names them; the types themselves are generated from the crate. */
export type { Noise, Scenario, Threshold } from "./generated/Scenario";

export type EstimatorName = "kf" | "ortho" | "uc-kf" | "et-kf" | "eskf" | "eskf-raw";

/** Names the field uses, in the order the page lists them. */
export const ESTIMATORS: readonly { name: EstimatorName; label: string; meaning: string }[] = [
  { name: "kf", label: "KF", meaning: "Kalman filter, no constraint" },
  { name: "ortho", label: "KF-ortho", meaning: "KF, projected onto rotations at every step" },
  { name: "uc-kf", label: "UC-KF", meaning: "KF with the unitary constraint" },
  { name: "et-kf", label: "ET-KF", meaning: "KF, projected when the defect exceeds ε" },
  { name: "eskf", label: "ESKF", meaning: "error-state KF on rotations" },
  { name: "eskf-raw", label: "ESKF raw", meaning: "error-state KF on unprojected squared ranges" },
];

export function estimatorLabel(name: string): string {
  return ESTIMATORS.find((estimator) => estimator.name === name)?.label ?? name;
}
