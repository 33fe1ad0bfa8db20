import { keep, recall } from "./storage";

/** What can be made larger or put away: the panel of controls (on narrow screens a sheet) and the plots. */
export const PANES = ["panel", "plots", "sheet"] as const;
export type Pane = (typeof PANES)[number];

interface Place {
  /** Pixels across; null as the design has it. */
  readonly size: number | null;
  readonly open: boolean;
}

const KEY = "layout";

/** How the visitor arranged the frame, remembered from visit to visit. A sheet starts closed: it covers the scene. */
export class Layout {
  #places: Record<Pane, Place> = $state.raw({ ...AS_DESIGNED, ...recalled(), sheet: AS_DESIGNED.sheet });

  size(pane: Pane): number | null {
    return this.#places[pane].size;
  }

  isOpen(pane: Pane): boolean {
    return this.#places[pane].open;
  }

  resize(pane: Pane, size: number | null): void {
    this.#set(pane, { size, open: true });
  }

  toggle(pane: Pane, open = !this.isOpen(pane)): void {
    this.#set(pane, { ...this.#places[pane], open });
  }

  #set(pane: Pane, place: Place): void {
    this.#places = { ...this.#places, [pane]: place };
    keep(KEY, JSON.stringify(this.#places));
  }
}

const AS_DESIGNED: Record<Pane, Place> = {
  panel: { size: null, open: true },
  plots: { size: null, open: true },
  sheet: { size: null, open: false },
};

/** The places kept by the last visit, as far as they make sense. */
function recalled(): Partial<Record<Pane, Place>> {
  try {
    const kept: unknown = JSON.parse(recall(KEY) ?? "{}");
    const entries = Object.entries(kept as Record<string, Place>);
    return Object.fromEntries(
      entries.filter(([pane, place]) => PANES.includes(pane as Pane) && sensible(place)),
    );
  } catch {
    return {};
  }
}

function sensible(place: Place | null): boolean {
  const size = place?.size;
  return typeof place?.open === "boolean" && (size === null || (typeof size === "number" && size > 0));
}
