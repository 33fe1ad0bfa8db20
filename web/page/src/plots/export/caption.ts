import { formatNumber } from "../../controls/format";
import type { PlotSource, PlotSpec } from "../spec";

/** Where a picture or a table comes from: it goes into every exported file. */
export interface Origin extends PlotSource {
  readonly lab: string;
  /** The address that opens exactly this scenario. */
  readonly link: string;
}

/** What the numbers are of, for people: "scenario “room”, seed 1, trials 0 to 1999". */
export function describeOrigin({ lab, scenario, trials }: Origin): string {
  const of = trials === null ? "trial 0" : `trials 0 to ${trials - 1}`;
  return `rangelab ${lab}, scenario “${scenario.name || "without a name"}”, seed ${scenario.seed}, ${of}`;
}

/** `rangelab-track-room-orientation-error-seed-1-200-trials.csv`: lower case, no blanks, no signs. */
export function fileName(spec: PlotSpec, { lab, scenario, trials }: Origin, extension: string): string {
  const parts = ["rangelab", lab, scenario.name, spec.title, `seed ${scenario.seed}`];
  if (trials !== null) parts.push(`${trials} trials`);
  return `${parts.map(slug).filter(Boolean).join("-")}.${extension}`;
}

function slug(text: string): string {
  const plain = text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
  return plain.replace(/[^a-z0-9.]+/g, "-").replace(/^-+|-+$/g, "");
}

/** What is drawn besides the lines, in sentences. */
export function remarks({ bands, threshold, x }: PlotSpec): string[] {
  const list = bands.map(
    ({ low, high, label }) => `Band from ${formatNumber(low)} to ${formatNumber(high)}: ${label}.`,
  );
  if (x.now !== null) list.push(`The scenario lies at ${x.name} ${formatNumber(x.now)} ${x.unit}.`);
  for (const { label, place } of x.marks ?? [])
    list.push(`${label}: ${x.name} ${formatNumber(place)} ${x.unit}.`);
  if (threshold) list.push(`${threshold.name} = ${formatNumber(threshold.value)}.`);
  return list;
}
