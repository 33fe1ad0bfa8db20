export const BACKENDS = ["webgpu", "webgl", "canvas2d"] as const;
export type Backend = (typeof BACKENDS)[number];

/** `?renderer=webgl` in the address asks for one; without it all are tried, best first. */
export function wantedBackends(search: string): readonly Backend[] {
  const wanted = new URLSearchParams(search).get("renderer");
  const first = BACKENDS.indexOf(wanted as Backend);
  return first < 0 ? BACKENDS : BACKENDS.slice(first);
}

/** Milliseconds that a browser has to say whether it has an adapter, and a module to load and start. */
const ADAPTER_LIMIT = 3000;
const START_LIMIT = 30_000;

/** `navigator.gpu` exists on machines without an adapter, so it is asked for one before a module is loaded. */
export async function offers(backend: Backend): Promise<boolean> {
  if (backend === "canvas2d") return true;
  if (backend === "webgl") return document.createElement("canvas").getContext("webgl2") !== null;
  const gpu = (navigator as { gpu?: { requestAdapter(): Promise<object | null> } }).gpu;
  if (!gpu) return false;
  return Boolean(await within(ADAPTER_LIMIT, gpu.requestAdapter()));
}

/** Starts something that must not keep the page waiting: late things are let go. */
export async function startWithin<T>(start: Promise<T>, letGo: (late: T) => void): Promise<T> {
  let inTime = true;
  void start.then(
    (value) => inTime || letGo(value),
    () => undefined,
  );
  try {
    return await within(START_LIMIT, start);
  } catch (error) {
    inTime = false;
    throw error;
  }
}

/** Rejects where the answer does not come within so many milliseconds. */
export function within<T>(milliseconds: number, answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`no answer within ${milliseconds} ms`)), milliseconds);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}
