import type { Run } from "../../run";
import { findings } from "./findings";

/** More than these nobody reads while the scene moves. */
const MOST = 3;

/** What the run shows at a step, in at most three sentences. */
export function describe(run: Run, step: number): string {
  const all = findings(run, Math.min(step, run.steps - 1));
  const least = all.map(({ weight }) => weight).sort((one, other) => other - one)[MOST - 1] ?? 0;
  return all
    .filter(({ weight }) => weight >= least)
    .slice(0, MOST)
    .map(({ text }) => text)
    .join(" ");
}
