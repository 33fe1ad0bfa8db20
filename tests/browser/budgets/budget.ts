import { expect, type TestInfo } from "@playwright/test";

/** One line of the report. */
export interface Budget {
  readonly name: string;
  readonly measured: string;
  readonly limit: string;
  readonly kept: boolean;
  /** A figure that every machine measures alike decides the test; the others are only reported. */
  readonly decides: boolean;
}

export const ANNOTATION = "budget";

/** Puts the line into the report; fails the test where a deciding budget is broken. */
export function report(info: TestInfo, budget: Budget): void {
  info.annotations.push({ type: ANNOTATION, description: JSON.stringify(budget) });
  if (budget.decides)
    expect.soft(budget.kept, `${budget.name}: ${budget.measured}, limit ${budget.limit}`).toBe(true);
}

/** At most `limit` of a unit. */
export function atMost(
  info: TestInfo,
  name: string,
  value: number,
  limit: number,
  unit: string,
  decides: boolean,
): void {
  const show = (number: number) => `${number.toFixed(number < 100 ? 1 : 0)} ${unit}`;
  report(info, {
    name,
    measured: show(value),
    limit: `at most ${limit} ${unit}`,
    kept: value <= limit,
    decides,
  });
}

export function quantile(values: readonly number[], share: number): number {
  return [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))];
}
