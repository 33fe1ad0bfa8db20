import { backward, type Camera, orbit, zoom } from "./camera";

/** What a key asks of the scene. */
export type SceneAction =
  | { readonly kind: "select"; readonly by: 1 | -1 }
  | { readonly kind: "choose"; readonly index: number }
  | { readonly kind: "nudge"; readonly direction: readonly [number, number, number] }
  | { readonly kind: "camera"; readonly camera: Camera }
  | { readonly kind: "release" }
  | { readonly kind: "add" }
  | { readonly kind: "remove" };

const TURN = 0.12;
const NEARER = 1.15;

/** Arrow keys move the selected anchor the way they point on the screen, and turn the scene where none is selected. */
export function sceneAction(key: string, camera: Camera, selected: number | null): SceneAction | null {
  if (/^[1-9]$/.test(key)) return { kind: "choose", index: Number(key) - 1 };
  switch (key) {
    case "n":
      return { kind: "select", by: 1 };
    case "p":
      return { kind: "select", by: -1 };
    case "a":
      return { kind: "add" };
    case "+":
    case "=":
      return { kind: "camera", camera: zoom(camera, NEARER) };
    case "-":
      return { kind: "camera", camera: zoom(camera, 1 / NEARER) };
  }
  if (selected === null) return turn(key, camera);
  if (key === "Escape") return { kind: "release" };
  if (key === "Delete" || key === "Backspace") return { kind: "remove" };
  const direction = nudgeDirection(key, camera);
  return direction && { kind: "nudge", direction };
}

function turn(key: string, camera: Camera): SceneAction | null {
  const turns: Record<string, Camera> = {
    ArrowLeft: orbit(camera, -TURN, 0),
    ArrowRight: orbit(camera, TURN, 0),
    ArrowUp: orbit(camera, 0, TURN),
    ArrowDown: orbit(camera, 0, -TURN),
  };
  return key in turns ? { kind: "camera", camera: turns[key] } : null;
}

/** Along the world axis that lies nearest to the key's direction on the screen. */
function nudgeDirection(key: string, camera: Camera): readonly [number, number, number] | null {
  const away = backward({ ...camera, pitch: 0 });
  const towards: Record<string, readonly [number, number]> = {
    ArrowRight: [-away[1], away[0]],
    ArrowLeft: [away[1], -away[0]],
    ArrowUp: [-away[0], -away[1]],
    ArrowDown: [away[0], away[1]],
  };
  if (key === "PageUp") return [0, 0, 1];
  if (key === "PageDown") return [0, 0, -1];
  if (!(key in towards)) return null;
  const [x, y] = towards[key];
  return Math.abs(x) >= Math.abs(y) ? [Math.sign(x), 0, 0] : [0, Math.sign(y), 0];
}
