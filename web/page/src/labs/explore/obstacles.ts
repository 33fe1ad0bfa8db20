import type { Scenario } from "../../scenario";
import type { Obstacle } from "../../generated/Obstacle";
import type { DrawList } from "../../scene/draw-list";
import type { Frame } from "../../scene/frame";
import type { Vec3 } from "../../scene/geometry";
import type { Layer } from "../../scene/input";
import type { ExploreRun } from "./run";

/** Corners of a face in order. */
type Face = readonly Vec3[];

/** What blocks lines of sight: edges, and faces one sees through. */
export const obstacles: Layer<ExploreRun, Scenario> = ({ scenario, frame, palette }, out) => {
  const line = { width: 1.5, color: palette.rgba("ink-soft", 0.8) };
  for (const obstacle of scenario.availability.obstacles) {
    for (const face of facesOf(obstacle, frame)) {
      out.polyline([...face, face[0]], line);
      fill(face, palette.rgba("ink-soft", 0.14), out);
    }
  }
};

/** A planar scene has lines and rectangles at height 0; a wall without an end reaches as far as the scene does. */
export function facesOf(obstacle: Obstacle, frame: Pick<Frame, "flat" | "ground" | "whole">): Face[] {
  const { flat, ground, whole } = frame;
  if (obstacle.kind === "wall") {
    const [x, y] = [obstacle.from, obstacle.to];
    if (flat) return [[at(x, 0), at(y, 0)]];
    const [bottom, top] = [obstacle.bottom ?? ground, obstacle.top ?? Math.max(whole[1][2], ground)];
    return [[at(x, bottom), at(y, bottom), at(y, top), at(x, top)]];
  }
  const { low, high } = obstacle;
  const corners: readonly number[][] = [
    [low[0], low[1]],
    [high[0], low[1]],
    [high[0], high[1]],
    [low[0], high[1]],
  ];
  if (flat) return [corners.map((corner) => at(corner, 0))];
  const sides = corners.map((corner, index): Face => {
    const next = corners[(index + 1) % 4];
    return [at(corner, low[2]), at(next, low[2]), at(next, high[2]), at(corner, high[2])];
  });
  return [
    ...sides,
    corners.map((corner) => at(corner, low[2])),
    corners.map((corner) => at(corner, high[2])),
  ];
}

function at(point: readonly number[], z: number): Vec3 {
  return [point[0], point[1], z];
}

function fill(face: Face, color: Parameters<DrawList["triangle"]>[1], out: DrawList): void {
  for (let i = 2; i < face.length; i++) out.triangle([face[0], face[i - 1], face[i]], color);
}
