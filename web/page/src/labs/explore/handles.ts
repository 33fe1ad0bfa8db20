import type { Region } from "../../generated/Region";
import type { Scenario } from "../../scenario";
import { coordinateStep } from "../../state/edit";
import type { Handle } from "../../state/handles";
import { startOf } from "../../words";
import { obstacleBoxPart, type Part, placementParts, wallPart } from "./parts";

/** The ends and corners of walls and boxes, each whole by its middle. */
export function handles(scenario: Scenario): Handle<Scenario>[] {
  return [
    ...placementParts(scenario).flatMap((part) => boxHandles(part, scenario)),
    ...scenario.availability.obstacles.flatMap(({ kind }, index) =>
      kind === "wall" ? wallHandles(wallPart(index), scenario) : boxHandles(obstacleBoxPart(index), scenario),
    ),
  ];
}

/** The handle by which a box or wall is taken as a whole. */
export function middleOf(part: { readonly id: string }): string {
  return `${part.id} middle`;
}

type Move = Handle<Scenario>["move"];

/** The middle comes first: where it is moved together with corners, those then find the box beside them. */
function boxHandles(part: Part<Region>, scenario: Scenario): Handle<Scenario>[] {
  const { low, high } = part.of(scenario);
  const moveLow: Move = (next, place) => {
    const [box, gap] = [part.of(next), coordinateStep(next)];
    return part.set(next, {
      ...box,
      low: place.map((value, i) => Math.min(value, clean(box.high[i] - gap))),
    });
  };
  const moveHigh: Move = (next, place) => {
    const [box, gap] = [part.of(next), coordinateStep(next)];
    return part.set(next, {
      ...box,
      high: place.map((value, i) => Math.max(value, clean(box.low[i] + gap))),
    });
  };
  const moveAll: Move = (next, place) => {
    const box = part.of(next);
    const foot = footOf(box);
    const along = (corner: number[]) => corner.map((value, i) => clean(value + place[i] - foot[i]));
    return part.set(next, { low: along(box.low), high: along(box.high) });
  };
  return [
    handle(part, "middle", "diamond", footOf({ low, high }), moveAll),
    handle(part, "low corner", "square", low, moveLow),
    handle(part, "high corner", "square", high, moveHigh),
  ];
}

/** The middle of what a box stands on: that is easier to place than a point in the air. */
function footOf({ low, high }: Region): number[] {
  return low.map((value, axis) => (axis === 2 ? value : clean((value + high[axis]) / 2)));
}

/** A wall stays at its height. */
function wallHandles(part: ReturnType<typeof wallPart>, scenario: Scenario): Handle<Scenario>[] {
  const { from, to, bottom } = part.of(scenario);
  const moveAll: Move = (next, place) => {
    const wall = part.of(next);
    const middle = between(wall.from, wall.to);
    const along = (end: number[]) => end.map((value, i) => clean(value + place[i] - middle[i]));
    return part.set(next, { ...wall, from: along(wall.from), to: along(wall.to) });
  };
  const level = bottom ?? undefined;
  return [
    { ...handle(part, "middle", "diamond", between(from, to), moveAll), level },
    {
      ...handle(part, "end A", "square", from, (next, place) =>
        part.set(next, { ...part.of(next), from: place.slice(0, 2) }),
      ),
      level,
    },
    {
      ...handle(part, "end B", "square", to, (next, place) =>
        part.set(next, { ...part.of(next), to: place.slice(0, 2) }),
      ),
      level,
    },
  ];
}

function handle<T>(
  part: Part<T>,
  which: string,
  mark: Handle["mark"],
  place: readonly number[],
  move: Move,
): Handle<Scenario> {
  return {
    id: `${part.id} ${which}`,
    name: `${startOf(part.name)}, ${which}`,
    place,
    mark,
    token: part.token,
    move,
    whole: { name: startOf(part.name), without: part.without },
  };
}

function between(from: readonly number[], to: readonly number[]): number[] {
  return from.map((value, axis) => clean((value + to[axis]) / 2));
}

/** Sums without the noise of their last bits. */
function clean(value: number): number {
  return Number(value.toFixed(9)) + 0;
}
