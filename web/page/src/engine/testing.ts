import { modules } from ".";

/** The engine for unit tests, which have no server to load it from: its bytes stand in the test's own code. */
const inlined = import.meta.glob<string>(["../wasm/*/*.wasm", "!../wasm/scene-*/*"], {
  query: "?url&inline",
  import: "default",
});

export async function loadEngineForTests(): Promise<void> {
  for (const [name, module] of Object.entries(modules)) {
    const load = inlined[`../wasm/${name}/rangelab_${name}_bg.wasm`];
    const response = await fetch(await load());
    await module.load(await WebAssembly.compile(await response.arrayBuffer()));
  }
}
