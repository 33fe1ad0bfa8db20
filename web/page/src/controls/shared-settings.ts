import type { NumberSetting } from "./setting";

/** Numbers that scenarios of several kinds have. */

export const SEED: NumberSetting = { path: "seed", label: "Seed", unit: "", step: 1, min: 0 };

/** Part of the measurements that are not there, at this path of the scenario. */
export function missing(path: string, label: string): NumberSetting {
  return { path, label, unit: "%", factor: 100, min: 0, max: 100, step: 5, scale: { min: 0, max: 90 } };
}
