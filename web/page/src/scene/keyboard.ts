import { backward, type Camera, orbit, pan, zoom } from "./camera";
import type { Viewport } from "./view";

/** What a key asks of the scene. */
export type SceneAction =
  | { readonly kind: "next"; readonly by: 1 | -1 }
  | { readonly kind: "choose"; readonly index: number }
  | { readonly kind: "nudge"; readonly direction: readonly [number, number, number] }
  | { readonly kind: "camera"; readonly camera: Camera }
  | { readonly kind: Plain };
type Plain =
  "all" | "release" | "add" | "remove" | "duplicate" | "destination" | "several" | "fit" | "body" | "centre";

const PLAIN_KEYS: Readonly<Record<string, Plain>> = {
  a: "add",
  b: "body",
  c: "centre",
  d: "duplicate",
  f: "fit",
  g: "destination",
  m: "several",
  Delete: "remove",
  Backspace: "remove",
  Escape: "release",
};

const TURN = 0.12;
const NEARER = 1.15;
const STEP_PIXELS = 60;

interface Situation {
  readonly camera: Camera;
  readonly viewport: Viewport;
  readonly anyChosen: boolean;
  readonly planar: boolean;
}

/** Arrow keys move what is chosen the way they point on the screen; where nothing is, they turn or move the scene. */
export function sceneAction(event: KeyboardEvent, situation: Situation): SceneAction | null {
  const { key } = event;
  if (event.altKey) return null;
  if (event.ctrlKey || event.metaKey) return key.toLowerCase() === "a" ? { kind: "all" } : null;
  if (/^[1-9]$/.test(key)) return { kind: "choose", index: Number(key) - 1 };
  if (key === "n" || key === "p") return { kind: "next", by: key === "n" ? 1 : -1 };
  if (key in PLAIN_KEYS) return { kind: PLAIN_KEYS[key] };
  const camera = zoomed(key, situation.camera);
  if (camera) return { kind: "camera", camera };
  if (situation.anyChosen) {
    const direction = nudgeDirection(key, situation.camera);
    return direction && { kind: "nudge", direction };
  }
  const looked = look(key, event.shiftKey || situation.planar, situation);
  return looked && { kind: "camera", camera: looked };
}

function zoomed(key: string, camera: Camera): Camera | null {
  if (key === "+" || key === "=") return zoom(camera, NEARER);
  return key === "-" ? zoom(camera, 1 / NEARER) : null;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function look(key: string, pans: boolean, { camera, viewport }: Situation): Camera | null {
  if (!(key in ARROWS)) return null;
  const [right, up] = ARROWS[key];
  return pans
    ? pan(camera, -right * STEP_PIXELS, up * STEP_PIXELS, viewport)
    : orbit(camera, right * TURN, up * TURN);
}

/** Along the world axis that lies nearest to the key's direction on the screen. */
function nudgeDirection(key: string, camera: Camera): readonly [number, number, number] | null {
  if (key === "PageUp") return [0, 0, 1];
  if (key === "PageDown") return [0, 0, -1];
  if (!(key in ARROWS)) return null;
  const away = backward({ ...camera, pitch: 0 });
  const [right, up] = ARROWS[key];
  const x = -right * away[1] - up * away[0];
  const y = right * away[0] - up * away[1];
  return Math.abs(x) >= Math.abs(y) ? [Math.sign(x), 0, 0] : [0, Math.sign(y), 0];
}
