import type { SliderScale } from "./slider";

/** One number of the scenario as a control shows it. */
export interface NumberSetting {
  /** Where it stands in the scenario. */
  readonly path: string;
  readonly label: string;
  readonly unit: string;
  /** What is shown is the value times this: 100 for a percentage. */
  readonly factor?: number;
  /** In shown units; without one there are buttons instead of a slider. */
  readonly scale?: SliderScale;
  readonly step?: number;
  readonly min?: number;
  readonly max?: number;
  /** Whole numbers only: a slider stops at them. */
  readonly whole?: boolean;
}
