import { weightiest } from "../../findings";
import type { Run } from "../../run";
import { findings } from "./findings";

/** What matters most about the run at a step, in one to three sentences. */
export function describe(run: Run, step: number): string {
  return weightiest(findings(run, Math.min(step, run.steps - 1)));
}
