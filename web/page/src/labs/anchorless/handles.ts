import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import type { Handle } from "../../state/handles";
import { nodesOf } from "./family";
import { clean, gaugeOf, seen, turnedBack } from "./gauge";
import { arrowSeconds } from "./hints";

/** The arrows of a node at time 0: how the tip follows from the derivative, and what it is drawn with. */
export const ARROW_KINDS = [
  { l: 1, name: "velocity", token: "anchor", mark: "triangle", unit: "m/s" },
  { l: 2, name: "acceleration", token: "anchor", mark: "square", unit: "m/s²" },
] as const;

/** Metres from a node to the tip for each unit of the derivative: the way in that time, t or t²/2. */
export function reach(scenario: Pick<KinematicsScenario, "stamps" | "view">, l: number): number {
  const seconds = arrowSeconds(scenario);
  return l === 1 ? seconds : (seconds * seconds) / 2;
}

/** The tips of the arrows; a scenario without accelerations has none for them. */
export function handles(scenario: KinematicsScenario): Handle<KinematicsScenario>[] {
  const [nodes, coefficients] = [nodesOf(scenario), seen(scenario)];
  return ARROW_KINDS.filter(({ l }) => l < coefficients.length).flatMap(({ l, name, token, mark }) =>
    nodes.map((node, index): Handle<KinematicsScenario> => ({
      id: `${name} ${index}`,
      name: `Tip of the ${name} of node ${index + 1}`,
      place: clean(node.map((value, axis) => value + reach(scenario, l) * coefficients[l][index][axis])),
      mark,
      token,
      move: (next, place) => withTip(next, l, index, place),
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
