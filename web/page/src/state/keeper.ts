import type { SceneDocument } from "../family";
import { encodeLink } from "./link";
import { keep } from "./storage";

/** Where the last edited scenario lies between visits. */
export const AUTOSAVE = "scene";
/** Browsers count how often a page changes its address and stop one that does it with every key. */
const ADDRESS_DELAY_MILLISECONDS = 250;

/** Keeps the scenario where it outlives the page: in the browser's storage at once, in the address a moment later. */
export class Keeper {
  #latest: SceneDocument | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** After an edit. Each tab keeps its own scene in its address; the storage has the one edited last. */
  edited(scenario: SceneDocument): void {
    keep(AUTOSAVE, JSON.stringify(scenario));
    this.shown(scenario);
  }

  /** After a scene came up that nobody edited here: only the address names it. */
  shown(scenario: SceneDocument): void {
    this.#latest = scenario;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#write(scenario), ADDRESS_DELAY_MILLISECONDS);
  }

  async #write(scenario: SceneDocument): Promise<void> {
    // Without a link the address opens what the storage keeps.
    const link = await encodeLink(scenario).catch(() => location.pathname + location.search);
    if (scenario === this.#latest) history.replaceState(null, "", link);
  }
}
