import type { Run } from "../../run";
import { type Finding, findings } from "./findings";

/** More than this nobody reads while the scene moves. */
const MOST_SENTENCES = 3;
const MOST_CHARACTERS = 230;

/** What matters most about the run at a step, in one to three sentences. */
export function describe(run: Run, step: number): string {
  const all = findings(run, Math.min(step, run.steps - 1));
  const chosen = new Set<Finding>();
  let length = 0;
  for (const finding of all.toSorted((one, other) => other.weight - one.weight)) {
    length += finding.text.length + 1;
    if (chosen.size > 0 && (chosen.size === MOST_SENTENCES || length > MOST_CHARACTERS)) break;
    chosen.add(finding);
  }
  return all
    .filter((finding) => chosen.has(finding))
    .map(({ text }) => text)
    .join(" ");
}
