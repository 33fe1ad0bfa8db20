import { anchorlessModule, completeAnchorless, validateAnchorless } from "../../engine";
import type { Family } from "../../family";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import { dimensionOf, gaugeOf, isIdentity, middleOf, placedBack } from "./gauge";
import { nodesOf, tipsOf } from "./nodes";

/** Mobile nodes without anchors: what stands in the room are the nodes at time 0, as the gauge shows them. */
export const anchorless: Family<KinematicsScenario> = {
  name: "anchorless",
  anchor: "node",
  body: "network",
  load: () => anchorlessModule.load(),
  claims: (document) => "coefficients" in document,
  validate: validateAnchorless,
  complete: completeAnchorless,
  room(scenario) {
    const nodes = nodesOf(scenario);
    const middle = middleOf(nodes);
    return {
      dimension: dimensionOf(scenario),
      anchors: nodes,
      movable: true,
      start: middle,
      body: nodes.map((node) => node.map((value, axis) => value - middle[axis])),
      extent: [...nodes, ...tipsOf(scenario, 1), ...tipsOf(scenario, 2)],
    };
  },
  withAnchors(scenario, places) {
    const [gauge, nodes] = [gaugeOf(scenario), nodesOf(scenario)];
    const back = (place: readonly number[]) => (isIdentity(gauge) ? [...place] : placedBack(gauge, place));
    const same = (place: readonly number[], node: number) =>
      node < nodes.length && place.every((value, axis) => value === nodes[node][axis]);
    const [positions, ...others] = scenario.coefficients;
    const moved = places.map((place, node) => (same(place, node) ? positions[node] : back(place)));
    // A new node stands still.
    const still = places[0].map(() => 0);
    return {
      ...scenario,
      coefficients: [moved, ...others.map((points) => places.map((_, node) => points[node] ?? still))],
    };
  },
  withoutAnchors: (scenario, indices) => ({
    ...scenario,
    coefficients: scenario.coefficients.map((points) => points.filter((_, node) => !indices.includes(node))),
  }),
};
