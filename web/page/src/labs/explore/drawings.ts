import { formatPoint } from "../../controls/format";
import type { Region } from "../../generated/Region";
import type { Scenario } from "../../scenario";
import { coordinateStep } from "../../state/edit";
import type { Drawing, Drawn } from "../../state/handles";
import { startOf } from "../../words";
import { middleOf } from "./handles";
import { keepOutPart, limitsPart, obstacleBoxPart, type Part, regionPart, wallPart } from "./parts";

/** What one draws over the floor by hand, from the floor up to the top of the room. */
export const drawings: readonly Drawing<Scenario>[] = [
  boxDrawing("a keep-out box", ({ placement }) => keepOutPart(placement.keep_out.length)),
  boxDrawing("where the body may be", regionPart),
  boxDrawing("where anchors may stand", limitsPart),
  { name: "a wall", outline: "line", make: drawWall },
  boxDrawing("a box that blocks sight", ({ availability }) => obstacleBoxPart(availability.obstacles.length)),
];

function boxDrawing(name: string, partIn: (scenario: Scenario) => Part<Region>): Drawing<Scenario> {
  return {
    name,
    outline: "rectangle",
    make: (scenario, from, to) => {
      const gap = coordinateStep(scenario);
      const low = from.map((value, axis) => Math.min(value, to[axis]));
      const high = from.map((value, axis) => Math.max(value, to[axis], low[axis] + gap));
      return drawn(partIn(scenario), scenario, { low, high }, [low, high]);
    },
  };
}

function drawWall(scenario: Scenario, from: readonly number[], to: readonly number[]): Drawn<Scenario> {
  const [start, end] = [from.slice(0, 2), to.slice(0, 2)];
  const [bottom, top] = scenario.dimension === 2 ? [null, null] : [from[2], to[2]];
  const wall = { kind: "wall" as const, from: start, to: end, bottom, top };
  return drawn(wallPart(scenario.availability.obstacles.length), scenario, wall, [start, end]);
}

function drawn<T>(part: Part<T>, scenario: Scenario, shape: T, [from, to]: number[][]): Drawn<Scenario> {
  return {
    scenario: part.set(scenario, shape),
    what: `${startOf(part.name)} drawn from ${formatPoint(from)} to ${formatPoint(to)}`,
    handle: middleOf(part),
  };
}
