/** The scene renderer, a module of its own in two builds. */
import type { Scene } from "../wasm/scene-webgpu/rangelab_scene.js";

export type WasmScene = Scene;

/** Loads the scene module for the backend and starts it on the canvas. Rejects where the backend is not there. */
export async function createWasmScene(
  backend: "webgpu" | "webgl",
  canvas: HTMLCanvasElement,
): Promise<WasmScene> {
  const module =
    backend === "webgpu"
      ? await import("../wasm/scene-webgpu/rangelab_scene.js")
      : await import("../wasm/scene-webgl/rangelab_scene.js");
  await module.default();
  return module.Scene.create(canvas);
}
