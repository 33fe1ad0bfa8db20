import { mat4d } from "wgpu-matrix";
import { add, dot, scale, sub, type Vec3 } from "./geometry";

/** Where the viewer stands: around a target, z upward. Angles in rad; pitch 0 is level, pi/2 looks straight down. */
export interface Camera {
  readonly target: Vec3;
  readonly yaw: number;
  readonly pitch: number;
  readonly distance: number;
}

export interface Viewport {
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
}

export interface Ray {
  readonly origin: Vec3;
  readonly direction: Vec3;
}

export interface Projected {
  /** CSS pixels from the upper left corner. */
  readonly x: number;
  readonly y: number;
  /** Distance along the view direction; not positive behind the viewer. */
  readonly depth: number;
}

export const FIELD_OF_VIEW = (35 * Math.PI) / 180;
const PITCH_LIMIT = Math.PI / 2;

/** The view from a camera at one size: matrices and the ways between pixels and space. */
export class View {
  readonly #matrix: Float64Array;
  readonly #inverse: Float64Array;
  readonly eye: Vec3;

  constructor(
    readonly camera: Camera,
    readonly viewport: Viewport,
  ) {
    this.eye = add(camera.target, scale(backward(camera), camera.distance));
    const look = mat4d.lookAt(this.eye, camera.target, upward(camera));
    const aspect = viewport.width / Math.max(1, viewport.height);
    const near = camera.distance / 100;
    const projection = mat4d.perspective(FIELD_OF_VIEW, aspect, near, camera.distance * 200);
    this.#matrix = mat4d.multiply(projection, look);
    this.#inverse = mat4d.inverse(this.#matrix);
  }

  /** Column by column, clip depth 0..1. */
  get matrix(): Float32Array {
    return new Float32Array(this.#matrix);
  }

  project(point: Vec3): Projected {
    const [x, y, , w] = multiply(this.#matrix, [...point, 1]);
    return {
      x: ((x / w + 1) / 2) * this.viewport.width,
      y: ((1 - y / w) / 2) * this.viewport.height,
      depth: w,
    };
  }

  /** The ray from the eye through a pixel. */
  ray(x: number, y: number): Ray {
    const ndcX = (2 * x) / this.viewport.width - 1;
    const ndcY = 1 - (2 * y) / this.viewport.height;
    const [px, py, pz, pw] = multiply(this.#inverse, [ndcX, ndcY, 0.5, 1]);
    const through: Vec3 = [px / pw, py / pw, pz / pw];
    const difference: Vec3 = [through[0] - this.eye[0], through[1] - this.eye[1], through[2] - this.eye[2]];
    return { origin: this.eye, direction: scale(difference, 1 / Math.hypot(...difference)) };
  }

  /** Metres a CSS pixel covers at the depth of `point`. */
  metresPerPixel(point: Vec3): number {
    const depth = Math.max(1e-9, this.project(point).depth);
    return (2 * depth * Math.tan(FIELD_OF_VIEW / 2)) / Math.max(1, this.viewport.height);
  }
}

export function orbit(camera: Camera, deltaYaw: number, deltaPitch: number): Camera {
  const pitch = Math.min(PITCH_LIMIT, Math.max(-PITCH_LIMIT, camera.pitch + deltaPitch));
  return { ...camera, yaw: camera.yaw + deltaYaw, pitch };
}

/** Moves the scene under the pointer by CSS pixels. */
export function pan(camera: Camera, deltaX: number, deltaY: number, viewport: Viewport): Camera {
  const metres = (2 * camera.distance * Math.tan(FIELD_OF_VIEW / 2)) / Math.max(1, viewport.height);
  const sideways = scale(rightward(camera), -deltaX * metres);
  const upwards = scale(upward(camera), deltaY * metres);
  return { ...camera, target: add(camera.target, add(sideways, upwards)) };
}

/** Goes nearer for factors above 1. */
export function zoom(camera: Camera, factor: number): Camera {
  return { ...camera, distance: Math.min(1e9, Math.max(1e-3, camera.distance / factor)) };
}

export type Direction = "space" | "top" | "side";
const DIRECTIONS: Record<Direction, { yaw: number; pitch: number }> = {
  space: { yaw: -1.05, pitch: 0.5 },
  top: { yaw: -Math.PI / 2, pitch: Math.PI / 2 },
  side: { yaw: -Math.PI / 2, pitch: 0 },
};

/** Share of the half width or height that the outermost points may take. */
const FILL = 0.84;

/**
 * Looks at `centre` from the given direction, just far enough to see all points. What lies over the left of the view
 * (`inset` CSS pixels wide) is kept clear.
 */
export function fit(
  centre: Vec3,
  points: readonly Vec3[],
  direction: Direction,
  viewport: Viewport,
  inset = 0,
): Camera {
  const camera: Camera = { target: centre, ...DIRECTIONS[direction], distance: 1 };
  const [right, up, back] = [rightward(camera), upward(camera), backward(camera)];
  const tangent = FILL * Math.tan(FIELD_OF_VIEW / 2);
  const aspect = (viewport.width - inset) / Math.max(1, viewport.height);
  const needed = points.map((point) => {
    const offset = sub(point, centre);
    const width = Math.abs(dot(offset, right)) / (tangent * aspect);
    return Math.max(width, Math.abs(dot(offset, up)) / tangent) + dot(offset, back);
  });
  return pan({ ...camera, distance: Math.max(1e-3, ...needed) }, inset / 2, 0, viewport);
}

export function backward({ yaw, pitch }: Camera): Vec3 {
  return [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
}

function upward({ yaw, pitch }: Camera): Vec3 {
  return [-Math.sin(pitch) * Math.cos(yaw), -Math.sin(pitch) * Math.sin(yaw), Math.cos(pitch)];
}

function rightward({ yaw }: Camera): Vec3 {
  return [-Math.sin(yaw), Math.cos(yaw), 0];
}

function multiply(m: Float64Array, v: number[]): [number, number, number, number] {
  const row = (r: number) => m[r] * v[0] + m[r + 4] * v[1] + m[r + 8] * v[2] + m[r + 12] * v[3];
  return [row(0), row(1), row(2), row(3)];
}
