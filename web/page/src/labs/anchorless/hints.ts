import type { KinematicsScenario } from "../../generated/KinematicsScenario";

/** How the lab draws a scenario, kept among the scenario's hints for the page: it travels with it and can be undone. */
export interface Hint {
  readonly key: string;
  readonly label: string;
  readonly unit: string;
  readonly least: number;
  readonly most: number;
}

/** Arrows reach where the velocity alone, or the acceleration alone, would carry a node in this time. */
export const ARROWS: Hint = {
  key: "arrow_seconds",
  label: "Arrows reach",
  unit: "s",
  least: 1e-3,
  most: 1e7,
};
/** How many times larger errors are drawn than they are. */
export const ERRORS: Hint = { key: "error_scale", label: "Errors drawn", unit: "×", least: 1, most: 1e9 };

/** A hint may be anything: a link can be written by hand. */
export function hintOf(
  { view }: Pick<KinematicsScenario, "view">,
  { key, least, most }: Hint,
): number | null {
  const value = view?.[key];
  return typeof value === "number" && value >= least && value <= most ? value : null;
}

/** The first and the last stamp, s. */
export function intervalOf({ stamps }: Pick<KinematicsScenario, "stamps">): readonly [number, number] {
  if (stamps.kind === "regular") return [stamps.first, stamps.last];
  return [Math.min(...stamps.times), Math.max(...stamps.times)];
}

/** Twice the interval, unless the scenario says another time. */
export function arrowSeconds(scenario: Pick<KinematicsScenario, "stamps" | "view">): number {
  const [first, last] = intervalOf(scenario);
  return hintOf(scenario, ARROWS) ?? (last > first ? 2 * (last - first) : 1);
}

/** Metres from a node to the tip of its arrow for each unit of the derivative: the way in that time, t or t²/2. */
export function reach(scenario: Pick<KinematicsScenario, "stamps" | "view">, l: number): number {
  const seconds = arrowSeconds(scenario);
  return l === 1 ? seconds : (seconds * seconds) / 2;
}
