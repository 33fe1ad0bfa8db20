import type { Reporter, TestCase, TestResult } from "@playwright/test/reporter";
import { ANNOTATION, type Budget } from "./budget";

/** Prints the budgets that the tests recorded as one table. */
export default class BudgetReporter implements Reporter {
  readonly #budgets: Budget[] = [];

  onTestEnd(_test: TestCase, result: TestResult): void {
    for (const { type, description } of result.annotations)
      if (type === ANNOTATION && description) this.#budgets.push(JSON.parse(description) as Budget);
  }

  onEnd(): void {
    const rows = this.#budgets.map(({ name, measured, limit, kept, decides }) => [
      name,
      measured,
      limit,
      kept ? "kept" : decides ? "BROKEN" : "over, on this machine",
    ]);
    const table = [["budget", "measured", "limit", "verdict"], ...rows];
    const widths = table[0].map((_, column) => Math.max(...table.map((row) => row[column].length)));
    console.log(
      `\n${table.map((row) => row.map((cell, column) => cell.padEnd(widths[column])).join("  ")).join("\n")}\n`,
    );
  }
}
