import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { clean, type Points, seen } from "./gauge";
import { reach } from "./hints";

const shown = new WeakMap<KinematicsScenario, Points>();

/** The nodes at time 0 as they are seen. */
export function nodesOf(scenario: KinematicsScenario): Points {
  const known = shown.get(scenario);
  if (known) return known;
  const nodes = seen(scenario)[0].map(clean);
  shown.set(scenario, nodes);
  return nodes;
}

/** The tips of the arrows of the l-th derivative, node by node; none where the motion has no such derivative. */
export function tipsOf(scenario: KinematicsScenario, l: number): Points {
  const vectors = seen(scenario)[l] ?? [];
  const way = reach(scenario, l);
  const nodes = nodesOf(scenario);
  return vectors.map((vector, node) => clean(vector.map((value, axis) => nodes[node][axis] + way * value)));
}
