import type { Scenario } from "../../scenario";

/** What the lab shows of a scenario, kept among the scenario's hints for the page: they travel with it and can be undone. */

/** Trials of the cloud. */
export const CLOUD = { key: "cloud", label: "Trials of the cloud", first: 50, least: 1, most: 500 } as const;
/** The trial whose estimates are drawn as bodies. */
export const SHOWN = { key: "trial", label: "Trial drawn", first: 0, least: 0, most: 9999 } as const;

type Hint = typeof CLOUD | typeof SHOWN;

/** A hint may be anything: a link can be written by hand. */
export function hintOf({ view }: Pick<Scenario, "view">, { key, first, least, most }: Hint): number {
  const value = view?.[key];
  return typeof value === "number" && Number.isInteger(value) && value >= least && value <= most
    ? value
    : first;
}

/** Where it stands in the scenario. */
export function pathOf({ key }: Hint): string {
  return `view.${key}`;
}
