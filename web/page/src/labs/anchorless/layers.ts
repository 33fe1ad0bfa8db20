import { ellipsoidAxes } from "../../scene/ellipsoid";
import { add, length, lift, scale, sub, type Vec3 } from "../../scene/geometry";
import type { Layer } from "../../scene/input";
import type { KinematicsScenario } from "../../generated/KinematicsScenario";
import {
  across,
  arrowScale,
  errorAt,
  errorScale,
  foundArrow,
  trailsOf,
  trueArrows,
  truePlace,
} from "./drawn";
import { type BoundKind, boundKinds, estimatorOf } from "./estimators";
import type { AnchorlessRun } from "./run";

type AnchorlessLayer = Layer<AnchorlessRun, KinematicsScenario>;

/** Accelerations are dashed, velocities full. */
const DASH = { 1: 0, 2: 5 } as const;

/** While nodes are added or removed the scene is one step ahead of the run. */
function runThatFits({ run, room }: Parameters<AnchorlessLayer>[0]): AnchorlessRun | null {
  const fits = run?.anchors.length === room.anchors.length && run.dimension === room.dimension;
  return fits ? run : null;
}

/** The way of each node over the interval, and where it truly is at the step shown. */
export const motion: AnchorlessLayer = (input, out) => {
  const { step, palette } = input;
  const run = runThatFits(input);
  if (!run) return;
  trailsOf(run).forEach((trail, node) => {
    out.path(trail, step, run.steps - 1, { width: 1.5, color: palette.rgba("truth", 0.3) });
    out.path(trail, 0, step, { width: 3, color: palette.rgba("truth") });
    out.point(truePlace(run, step, node), 3.5, palette.rgba("truth"), "disc");
  });
};

const OPACITY: Record<BoundKind, number> = { distances: 0.16, accelerometers: 0.28 };

/** What the bounds allow, 95 %, of the nodes at the step shown and of the tips of their arrows, as magnified as errors are. */
export const uncertainty: AnchorlessLayer = (input, out) => {
  const { step, palette, frame } = input;
  const run = runThatFits(input);
  if (!run || !input.uncertainty.position) return;
  const [magnification, ofArrows, all] = [errorScale(input), arrowScale(input), trueArrows(input)];
  for (const kind of boundKinds(run.scenario.estimators.enabled)) {
    const ellipsoid = (covariances: Float64Array | null, node: number, at: Vec3, times: number) => {
      const axes = covariances && ellipsoidAxes(covariances, node, run.dimension, times);
      if (axes?.every((axis) => length(axis) < frame.radius))
        out.ellipsoid(at, axes, palette.rgba("bound", OPACITY[kind]));
    };
    all.forEach((ofNode, node) => {
      ellipsoid(run.covariances(kind, step), node, truePlace(run, step, node), magnification);
      for (const { l, to } of ofNode) ellipsoid(run.tipCovariances(kind, l), node, to, ofArrows);
    });
  }
};

/** The arrows at time 0, whose tips are dragged. */
export const arrows: AnchorlessLayer = (input, out) => {
  for (const arrow of trueArrows(input).flat()) {
    const style = { width: 2, color: input.palette.rgba("anchor"), dash: DASH[arrow.l] };
    out.arrow(arrow.from, sub(arrow.to, arrow.from), across(arrow), style);
  }
};

/** What each estimator found: the nodes at the step shown, joined to where they truly are, and the arrows at time 0. */
export const estimates: AnchorlessLayer = (input, out) => {
  const { step, palette } = input;
  const run = runThatFits(input);
  if (!run) return;
  const [magnification, ofArrows, all] = [errorScale(input), arrowScale(input), trueArrows(input)];
  run.trial.estimators.forEach((found, index) => {
    const { token, mark } = estimatorOf(found.name);
    // Estimates that agree lie on each other: earlier ones are drawn larger and show as rims.
    const rim = 0.5 * (run.trial.estimators.length - 1 - index);
    const color = palette.rgba(token);
    all.forEach((ofNode, node) => {
      if (found.coefficientErrors[0].length > 0)
        for (const arrow of ofNode) {
          const { l, from, to } = foundArrow(run, found, node, arrow, ofArrows);
          out.line(from, to, { width: 1.25 + rim, color, dash: DASH[l] });
          out.point(to, 2 + 0.75 * rim, color, mark);
        }
      const error = errorAt(run, found, step, node);
      if (!error) return;
      const truth = truePlace(run, step, node);
      const place = add(truth, scale(error, magnification));
      out.line(truth, place, { width: 1, color: palette.rgba(token, 0.5) });
      out.point(place, 4 + 1.5 * rim, color, mark);
    });
  });
};

/** More lines than this are drawn fainter. */
const MOST_LINES = 30;

/** A line between each two nodes: the distances, which is all that is measured without accelerometers. */
export const distances: AnchorlessLayer = ({ room, palette }, out) => {
  const nodes = room.anchors.map(lift);
  const many = (nodes.length * (nodes.length - 1)) / 2 > MOST_LINES;
  const style = { width: 1, color: palette.rgba("range", many ? 0.18 : 0.35) };
  nodes.forEach((one, i) => nodes.slice(i + 1).forEach((other) => out.line(one, other, style)));
};
