import { type PlotSpec, titleWithUnit, withUnit } from "../spec";
import { describeOrigin, type Origin, remarks } from "./caption";

/** Every step and figure to the last digit; comment lines start with #, gaps are empty. */
export function writeCsv(spec: PlotSpec, origin: Origin): string {
  const comments = [
    titleWithUnit(spec),
    describeOrigin(origin),
    `Seed: ${origin.scenario.seed}`,
    `Link: ${origin.link}`,
    ...remarks(spec),
  ];
  const columns = columnsOf(spec);
  const rows = Array.from(spec.x.values, (_, step) =>
    columns.map((column) => cell(column.at(step))).join(","),
  );
  const head = columns.map((column) => quoted(column.name)).join(",");
  return [...comments.map((line) => `# ${line}`), head, ...rows, ""].join("\r\n");
}

interface Column {
  readonly name: string;
  at(step: number): number;
}

function columnsOf({ x, lines, threshold, unit }: PlotSpec): Column[] {
  const inUnit = (name: string) => withUnit(name, unit);
  const columns: Column[] = [{ name: withUnit(x.name, x.unit), at: (step) => x.values[step] }];
  if (x.now === null) columns.unshift({ name: "step", at: (step) => step + 1 });
  for (const { label, values, standardErrors, events } of lines) {
    columns.push({ name: inUnit(label), at: (step) => values[step] });
    if (standardErrors)
      columns.push({ name: inUnit(`${label} standard error`), at: (step) => standardErrors[step] });
    if (events.length > 0)
      columns.push({ name: `${label} projected`, at: (step) => Number(events.includes(step)) });
  }
  if (threshold) columns.push({ name: inUnit("threshold"), at: (step) => threshold.heights[step] });
  return columns;
}

function cell(value: number): string {
  return Number.isFinite(value) ? String(value) : "";
}

function quoted(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
