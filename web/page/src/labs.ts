import type { Lab } from "./lab";
import type { Scenario } from "./scenario";

const modules = import.meta.glob<{ lab: Lab }>("./labs/*/index.ts", { eager: true });

/** Every lab there is, in the order of the header. */
export const LABS: readonly Lab[] = Object.values(modules)
  .map((module) => module.lab)
  .sort((a, b) => a.order - b.order);

/** The lab a scenario is for: the one its view names, the first where it names none, undefined where there is no such lab. */
export function labOf(scenario: Scenario, labs: readonly Lab[] = LABS): Lab | undefined {
  const wanted = scenario.view?.["lab"];
  return wanted === undefined ? labs[0] : labs.find((lab) => lab.name === wanted);
}

/** The scenario marked as one for the lab, so that its link opens there; the first lab needs no mark. */
export function forLab(scenario: Scenario, lab: Lab, labs: readonly Lab[] = LABS): Scenario {
  if (labOf(scenario, labs) === lab) return scenario;
  return { ...scenario, view: { ...scenario.view, lab: lab.name } };
}
