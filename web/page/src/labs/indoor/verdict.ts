import { formatReading } from "../../controls/format";
import { weightiest } from "../../findings";
import type { Convention } from "../../generated/Convention";
import type { IndoorReport } from "../../generated/IndoorReport";
import { asSentence, countOf } from "../../words";
import { filterOf } from "./filters";
import { lessons } from "./lessons";
import { levelsOfReport, levelsOfRun } from "./levels";
import type { IndoorRun } from "./run";

/** What one run shows, in up to three sentences. */
export function describe(run: IndoorRun): string {
  const stopped = run.filters.filter((filter) => filter.stopped !== null);
  const [first] = stopped.toSorted((one, other) => (one.stopped?.step ?? 0) - (other.stopped?.step ?? 0));
  const more = stopped.length > 1 ? `, and ${countOf(stopped.length - 1)} more` : "";
  const told = first?.stopped && {
    weight: 100,
    text: `${filterOf(first.name).label} stopped at step ${first.stopped.step + 1}${more}: ${asSentence(first.stopped.sentence)}`,
  };
  const levels = levelsOfRun(run);
  if (told && levels.length === 0) return told.text;
  return weightiest([...(told ? [told] : []), ...lessons(levels, run.scenario.imu.convention)]);
}

/** What the averages show, with how sure they are. */
export function verdict(report: IndoorReport, convention: Convention): string {
  const failed = report.filters.filter(({ summary }) => summary.failures > 0);
  const failures = failed.map(({ name, summary }) => ({
    weight: 100,
    text: `${filterOf(name).label} stopped in ${summary.failures} of ${report.trials} trials.`,
  }));
  const worst = Math.max(
    0,
    ...report.filters
      .map(({ summary: { position } }) => position.standard_error / position.value)
      .filter(Number.isFinite),
  );
  const sure = {
    weight: 95,
    text: `Mean over ${report.trials} trials, ±${formatReading(100 * worst)} % at most.`,
  };
  return weightiest([...failures, sure, ...lessons(levelsOfReport(report), convention)]);
}
