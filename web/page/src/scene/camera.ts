import { add, length, scale, sub, type Vec3 } from "./geometry";
import type { Frame } from "./frame";
import type { Pixel, View, Viewport } from "./view";

/** Where the viewer stands: around a target, z upward. Angles in rad; pitch 0 is level, pi/2 looks straight down. */
export interface Camera {
  readonly target: Vec3;
  readonly yaw: number;
  readonly pitch: number;
  readonly distance: number;
  /** Parallel rays of sight: the plane without foreshortening. */
  readonly orthographic: boolean;
}

const FIELD_OF_VIEW = (35 * Math.PI) / 180;
const PITCH_LIMIT = Math.PI / 2;

/** Half of what a view is high, in metres, at a distance from the eye. */
export const halfHeight = (distance: number): number => distance * Math.tan(FIELD_OF_VIEW / 2);

export function orbit(camera: Camera, deltaYaw: number, deltaPitch: number): Camera {
  const pitch = Math.min(PITCH_LIMIT, Math.max(-PITCH_LIMIT, camera.pitch + deltaPitch));
  return { ...camera, yaw: camera.yaw + deltaYaw, pitch };
}

/** Moves the scene under the pointer by CSS pixels. */
export function pan(camera: Camera, deltaX: number, deltaY: number, viewport: Viewport): Camera {
  const metres = (2 * halfHeight(camera.distance)) / Math.max(1, viewport.height);
  const sideways = scale(rightward(camera), -deltaX * metres);
  const upwards = scale(upward(camera), deltaY * metres);
  return { ...camera, target: add(camera.target, add(sideways, upwards)) };
}

/** Goes nearer for factors above 1. */
export function zoom(camera: Camera, factor: number): Camera {
  return { ...camera, distance: camera.distance / factor };
}

/** Goes nearer to what lies under a pixel: at the depth of the target it stays there. */
export function zoomTo(
  { camera, viewport }: Pick<View, "camera" | "viewport">,
  pixel: Pixel,
  factor: number,
): Camera {
  const share = 1 - 1 / factor;
  const [dx, dy] = [viewport.width / 2 - pixel.x, viewport.height / 2 - pixel.y];
  return zoom(pan(camera, dx * share, dy * share, viewport), factor);
}

/** How many times nearer and farther than the whole scene one can go, and how far beside it, in its radii. */
const NEAREST = 1 / 1000;
const FARTHEST = 30;
const BESIDE = 4;

/** Keeps the scene within reach: the nearest view that is still of it. */
export function limit(camera: Camera, { centre, radius }: Frame): Camera {
  const distance = Math.min(FARTHEST * radius, Math.max(NEAREST * radius, camera.distance));
  const offset = sub(camera.target, centre);
  const beside = length(offset) / (BESIDE * radius);
  const target = beside > 1 ? add(centre, scale(offset, 1 / beside)) : camera.target;
  return { ...camera, distance, target };
}

export const DIRECTIONS = {
  space: { yaw: -1.05, pitch: 0.5, orthographic: false },
  top: { yaw: -Math.PI / 2, pitch: Math.PI / 2, orthographic: false },
  front: { yaw: -Math.PI / 2, pitch: 0, orthographic: false },
  side: { yaw: 0, pitch: 0, orthographic: false },
  /** The only one of scenes in the plane. */
  plane: { yaw: -Math.PI / 2, pitch: Math.PI / 2, orthographic: true },
} as const;
export type Direction = Pick<Camera, "yaw" | "pitch" | "orthographic">;

export function backward({ yaw, pitch }: Camera): Vec3 {
  return [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
}

export function upward({ yaw, pitch }: Camera): Vec3 {
  return [-Math.sin(pitch) * Math.cos(yaw), -Math.sin(pitch) * Math.sin(yaw), Math.cos(pitch)];
}

export function rightward({ yaw }: Camera): Vec3 {
  return [-Math.sin(yaw), Math.cos(yaw), 0];
}
