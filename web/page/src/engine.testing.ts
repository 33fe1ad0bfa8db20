import { loadEngine } from "./engine";

/** The engine for unit tests, which have no server to load it from: its bytes stand in the test's own code. */
const inlined = import.meta.glob<string>("./wasm/rangelab/*.wasm", {
  query: "?url&inline",
  import: "default",
});

export async function loadEngineForTests(): Promise<void> {
  const [load] = Object.values(inlined);
  const response = await fetch(await load());
  await loadEngine(await WebAssembly.compile(await response.arrayBuffer()));
}
