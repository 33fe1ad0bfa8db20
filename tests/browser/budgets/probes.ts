import type { CDPSession, Page } from "@playwright/test";
import type { Lab } from "../lab";

/** Milliseconds from the start of the navigation to what a visitor waits for. */
export interface Firsts {
  picture: number;
  estimate: number;
}

/** To be called before the page is opened. */
export async function watchFirsts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const firsts: Record<string, number> = {};
    const awaited: Record<string, string> = {
      picture: ".host canvas",
      estimate: "[data-estimator] td",
    };
    Object.assign(window, { firsts });
    const observer = new MutationObserver(() => {
      for (const [name, selector] of Object.entries(awaited))
        if (!(name in firsts) && document.querySelector(selector))
          requestAnimationFrame(() => (firsts[name] ??= performance.now()));
    });
    observer.observe(document, { subtree: true, childList: true, attributes: true });
  });
}

export function readFirsts(page: Page): Promise<Firsts> {
  return page.evaluate(() => (window as unknown as { firsts: Firsts }).firsts);
}

/** Drags an anchor about and returns, for each frame that showed an effect, the time since its pointer event. */
export async function dragTimes(lab: Lab, moves = 40): Promise<number[]> {
  const { page } = lab;
  await page.evaluate(() => {
    const seen: number[] = [];
    Object.assign(window, { seen });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntriesByName("drag-to-picture")) seen.push(entry.duration);
    }).observe({ entryTypes: ["measure"] });
  });
  const from = await lab.anchorPixel(2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 0; i < moves; i++)
    await page.mouse.move(from.x + 50 * Math.sin(i / 9), from.y + 30 * Math.cos(i / 7));
  await page.mouse.up();
  await page.waitForTimeout(200);
  return page.evaluate(() => (window as unknown as { seen: number[] }).seen);
}

/** Milliseconds between frames for that long. */
export function frameTimes(page: Page, milliseconds: number): Promise<number[]> {
  return page.evaluate(
    (until) =>
      new Promise<number[]>((resolve) => {
        const times: number[] = [];
        const start = performance.now();
        let last = start;
        const next = (now: number) => {
          times.push(now - last);
          last = now;
          if (now - start < until) requestAnimationFrame(next);
          else resolve(times.slice(1));
        };
        requestAnimationFrame(next);
      }),
    milliseconds,
  );
}

/** To be called before the page is opened: keeps the memories of the WebAssembly instances in sight. */
export async function watchMemories(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const memories = new Set<WebAssembly.Memory>();
    Object.assign(window, { memories });
    const keep = (instance: WebAssembly.Instance) => {
      if (instance.exports["memory"] instanceof WebAssembly.Memory) memories.add(instance.exports["memory"]);
    };
    for (const name of ["instantiate", "instantiateStreaming"] as const) {
      const original = WebAssembly[name] as (...given: unknown[]) => Promise<unknown>;
      const wrapped = async (...given: unknown[]) => {
        const made = await original.apply(WebAssembly, given);
        keep(
          made instanceof WebAssembly.Instance
            ? made
            : (made as WebAssembly.WebAssemblyInstantiatedSource).instance,
        );
        return made;
      };
      Object.assign(WebAssembly, { [name]: wrapped });
    }
  });
}

/** Bytes in use after a collection: objects of the page, and all WebAssembly memory. */
export async function memoryInUse(
  page: Page,
  client: CDPSession,
): Promise<{ heap: number; modules: number }> {
  await client.send("HeapProfiler.enable");
  for (let i = 0; i < 3; i++) await client.send("HeapProfiler.collectGarbage");
  const { usedSize } = await client.send("Runtime.getHeapUsage");
  const modules = await page.evaluate(() =>
    [...(window as unknown as { memories: Set<WebAssembly.Memory> }).memories].reduce(
      (sum, memory) => sum + memory.buffer.byteLength,
      0,
    ),
  );
  return { heap: usedSize, modules };
}
