import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { Handle } from "../../state/handles";
import { clean, gaugeOf, turnedBack } from "./gauge";
import { reach } from "./hints";
import { nodesOf, tipsOf } from "./nodes";

/** The arrows of a node at time 0: how the tip follows from the derivative, and what it is drawn with. */
export const ARROW_KINDS = [
  { l: 1, name: "velocity", token: "anchor", mark: "triangle", unit: "m/s" },
  { l: 2, name: "acceleration", token: "anchor", mark: "square", unit: "m/s²" },
] as const;

/** The tips of the arrows; a scenario without accelerations has none for them. */
export function handles(scenario: KinematicsScenario): Handle<KinematicsScenario>[] {
  return ARROW_KINDS.flatMap(({ l, name, token, mark }) =>
    tipsOf(scenario, l).map((place, index): Handle<KinematicsScenario> => ({
      id: `${name} ${index}`,
      name: `Tip of the ${name} of node ${index + 1}`,
      place,
      mark,
      token,
      move: (next, tip) => withTip(next, l, index, tip),
    })),
  );
}

function withTip(
  scenario: KinematicsScenario,
  l: number,
  index: number,
  tip: readonly number[],
): KinematicsScenario {
  const node = nodesOf(scenario)[index];
  const way = reach(scenario, l);
  const vector = tip.map((value, axis) => (value - node[axis]) / way);
  return withVector(scenario, l, index, turnedBack(gaugeOf(scenario), vector));
}

/** The scenario with another derivative of one node at time 0. */
export function withVector(
  scenario: KinematicsScenario,
  l: number,
  index: number,
  vector: readonly number[],
): KinematicsScenario {
  const points = scenario.coefficients[l].map((old, node) => (node === index ? clean(vector) : old));
  return {
    ...scenario,
    coefficients: scenario.coefficients.map((old, other) => (other === l ? points : old)),
  };
}
