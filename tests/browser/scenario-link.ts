import { deflateSync, inflateSync } from "node:zlib";
import type { Lab } from "./lab";

/** What the tests change in a scenario. */
export interface Draft {
  anchors: number[][];
  sensors: number[][];
  noise: { kind: string; sigma: number };
  start: { position: number[] };
  steps: number;
  seed: number;
  [field: string]: unknown;
}

export const unpack = (hash: string): Draft =>
  JSON.parse(inflateSync(Buffer.from(hash.slice(4), "base64url")).toString()) as Draft;

export const pack = (value: unknown): string =>
  `#v1.${deflateSync(JSON.stringify(value)).toString("base64url")}`;

/** The link of the scene shown, after an edit that puts it into the address. */
export async function goodLink(lab: Lab, seed = 31): Promise<string> {
  await lab.type("Seed", String(seed));
  await lab.page.waitForFunction(
    (part) => location.hash.length > 20 && document.querySelector(".status")?.textContent?.includes(part),
    String(seed),
  );
  await lab.page.waitForTimeout(300);
  // Keys are meant for the page from here on.
  await lab.field("Seed").blur();
  return new URL(lab.page.url()).hash;
}

/** Opens the scene shown with a change, as from a link that somebody sent. */
export async function openChanged(lab: Lab, good: string, change: (draft: Draft) => void): Promise<void> {
  const draft = unpack(good);
  change(draft);
  await lab.page.evaluate((hash) => {
    location.hash = hash;
  }, pack(draft));
}
