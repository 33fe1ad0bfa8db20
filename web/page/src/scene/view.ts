import { mat4d } from "wgpu-matrix";
import { backward, type Camera, halfHeight, upward } from "./camera";
import { add, dot, scale, sub, type Vec3 } from "./geometry";

export interface Viewport {
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
}

export interface Pixel {
  /** CSS pixels from the upper left corner. */
  readonly x: number;
  readonly y: number;
}

export interface Projected extends Pixel {
  /** Distance along the view direction; not positive behind the viewer. */
  readonly depth: number;
}

export interface Ray {
  readonly origin: Vec3;
  readonly direction: Vec3;
}

/** The view from a camera at one size: matrices and the ways between pixels and space. */
export class View {
  readonly #matrix: Float64Array;
  readonly #inverse: Float64Array;
  readonly #forward: Vec3;
  readonly eye: Vec3;

  constructor(
    readonly camera: Camera,
    readonly viewport: Viewport,
  ) {
    const back = backward(camera);
    this.#forward = scale(back, -1);
    this.eye = add(camera.target, scale(back, camera.distance));
    const look = mat4d.lookAt(this.eye, camera.target, upward(camera));
    this.#matrix = mat4d.multiply(projection(camera, viewport), look);
    this.#inverse = mat4d.inverse(this.#matrix);
  }

  /** Column by column, clip depth 0..1. */
  get matrix(): Float32Array {
    return new Float32Array(this.#matrix);
  }

  project(point: Vec3): Projected {
    const m = this.#matrix;
    const [px, py, pz] = point;
    const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
    const x = (m[0] * px + m[4] * py + m[8] * pz + m[12]) / w;
    const y = (m[1] * px + m[5] * py + m[9] * pz + m[13]) / w;
    return {
      x: ((x + 1) / 2) * this.viewport.width,
      y: ((1 - y) / 2) * this.viewport.height,
      depth: this.#depth(point),
    };
  }

  /** The ray of sight through a pixel. */
  ray({ x, y }: Pixel): Ray {
    const ndcX = (2 * x) / this.viewport.width - 1;
    const ndcY = 1 - (2 * y) / this.viewport.height;
    if (this.camera.orthographic) return { origin: this.#unproject(ndcX, ndcY, 0), direction: this.#forward };
    const difference = sub(this.#unproject(ndcX, ndcY, 0.5), this.eye);
    return { origin: this.eye, direction: scale(difference, 1 / Math.hypot(...difference)) };
  }

  /** Where the ray of sight through a pixel meets the level plane at a height; null where it never does. */
  onLevel(pixel: Pixel, height: number): Vec3 | null {
    const { origin, direction } = this.ray(pixel);
    const along = (height - origin[2]) / direction[2];
    return Number.isFinite(along) && along > 0 ? add(origin, scale(direction, along)) : null;
  }

  /** Metres a CSS pixel covers at the depth of `point`. */
  metresPerPixel(point: Vec3): number {
    const depth = this.camera.orthographic ? this.camera.distance : Math.max(1e-9, this.#depth(point));
    return (2 * halfHeight(depth)) / Math.max(1, this.viewport.height);
  }

  #depth(point: Vec3): number {
    return dot(sub(point, this.eye), this.#forward);
  }

  #unproject(x: number, y: number, z: number): Vec3 {
    const m = this.#inverse;
    const row = (r: number) => m[r] * x + m[r + 4] * y + m[r + 8] * z + m[r + 12];
    const w = row(3);
    return [row(0) / w, row(1) / w, row(2) / w];
  }
}

/** Orthographic views are as large as perspective ones at the target. */
function projection({ distance, orthographic }: Camera, { width, height }: Viewport): Float64Array {
  const aspect = width / Math.max(1, height);
  const [half, near, far] = [halfHeight(distance), distance / 100, distance * 1000];
  if (orthographic) return mat4d.ortho(-half * aspect, half * aspect, -half, half, near, far);
  return mat4d.perspective(2 * Math.atan(halfHeight(1)), aspect, near, far);
}
