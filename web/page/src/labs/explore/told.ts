import type { Scenario } from "../../scenario";
import { DEGREES_PER_RADIAN, formatNumber, formatReading } from "../../controls/format";
import type { Exploration } from "../../generated/Exploration";
import { toldMounting } from "../../rigid-body/mounting";
import type { SceneInput } from "../../scene/input";
import { asSentence } from "../../words";
import { weakestMotion } from "./layers";
import { toldNext } from "./next-anchor";
import { nextSearch } from "./next-search.svelte";
import { toldAdvice } from "./placement";
import type { ExploreRun } from "./run";

export function describe({ exploration }: ExploreRun): string {
  const { sentence, twin } = exploration;
  return [sentence, ...(twin ? [twin.sentence] : [])].map(asSentence).join(" ");
}

/** The cause by its name, and whether a twin hides the pose: in a few words. */
export function hiddenFrom({ cause, twin }: Pick<Exploration, "cause" | "twin">): string {
  const seen =
    cause === null ? "Every small motion is seen" : `Not all is seen: ${cause.replaceAll("-", " ")}`;
  if (twin === null) return `${seen}.`;
  return `${seen}; ${twin.proper ? "another pose" : "a mirrored body"} has the same ranges (dashed).`;
}

/** What the ghost is, what the dots are, and which lines are dashed. */
export function note(input: SceneInput<ExploreRun, Scenario>): string {
  const { run } = input;
  if (!run) return "";
  const { missing, all } = missingRanges(run.exploration);
  const ranges = missing === 0 ? [] : [`${missing} of ${all} ranges cannot be measured: dashed`];
  const clouds = input.scenario.mounting_sigma > 0 ? ["dots: where the sensors may sit"] : [];
  return [ghostOf(input), ...clouds, ...ranges].filter((part) => part !== "").join("; ");
}

function ghostOf(input: SceneInput<ExploreRun, Scenario>): string {
  const motion = weakestMotion(input);
  if (!motion) return "";
  if (motion.times === null) return "Ghost (blue): the motion that no range sees";
  const sigma = motion.times === 1 ? "one σ" : `${formatNumber(motion.times)} σ`;
  return `Ghost (blue): the motion seen least, by ${sigma}`;
}

export function missingRanges({ available }: Pick<Exploration, "available">): {
  missing: number;
  all: number;
} {
  const all = available.flat();
  return { missing: all.filter((there) => !there).length, all: all.length };
}

/** The scene in words. */
export function told(input: SceneInput<ExploreRun, Scenario>): string[] {
  const { run, scenario } = input;
  if (!run) return [];
  const { exploration } = run;
  const { missing, all } = missingRanges(exploration);
  const walls = scenario.availability.obstacles.length;
  return [
    `Position bound ${metres(exploration.position_sigma)}, orientation bound ${degrees(exploration.angle_sigma)}.`,
    missing === 0 ? `All ${all} ranges can be measured.` : `${missing} of ${all} ranges cannot be measured.`,
    ...(walls > 0 ? [`${walls} walls and boxes block lines of sight.`] : []),
    ...toldMounting(scenario),
    ...toldAdvice(run.advice, scenario),
    ...toldNext(nextSearch.place),
    ...(exploration.modes.length > 0 ? [`${ghostOf(input)}.`] : []),
  ];
}

function metres(sigma: number | null): string {
  return sigma === null ? "does not exist" : `${formatReading(sigma)} m`;
}

function degrees(sigma: number | null): string {
  return sigma === null ? "does not exist" : `${formatReading(sigma * DEGREES_PER_RADIAN)} degrees`;
}
