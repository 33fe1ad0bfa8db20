import { parseHex, type Palette } from "./palette";

/**
 * Viridis (S. van der Walt and N. Smith, 2015, CC0) at sixteen even places: its lightness rises evenly for every eye.
 * Small numbers are dark, so that dark hatching is seen on the large ones.
 */
export const FIELD_STOPS = [
  "#440154",
  "#481a6c",
  "#472f7d",
  "#414487",
  "#39568c",
  "#31688e",
  "#2a788e",
  "#23888e",
  "#1f988b",
  "#22a884",
  "#35b779",
  "#54c568",
  "#7ad151",
  "#a5db36",
  "#d2e21b",
  "#fde725",
] as const;

/** Red, green, blue in 0..1, as sRGB values. */
export type Rgb = readonly [number, number, number];

/** Everything that a renderer colours a field with. */
export interface FieldColours {
  readonly stops: readonly Rgb[];
  readonly hatch: Rgb;
  readonly noBound: Rgb;
}

const known = new WeakMap<Palette, FieldColours>();

/** The colours of a theme, the same object each time. */
export function fieldColours(palette: Palette): FieldColours {
  const before = known.get(palette);
  if (before) return before;
  const colours = {
    stops: FIELD_STOPS.map(rgb),
    hatch: rgb(palette.css("hatch")),
    noBound: rgb(palette.css("no-bound")),
  };
  known.set(palette, colours);
  return colours;
}

function rgb(hex: string): Rgb {
  const [r, g, b] = parseHex(hex, 1);
  return [r, g, b];
}

/** The colour at a place of the scale, 0..1: linear between the stops, clamped, as all renderers do it. */
export function colourAt({ stops }: Pick<FieldColours, "stops">, place: number): Rgb {
  const along = Math.min(1, Math.max(0, place)) * (stops.length - 1);
  const stop = Math.min(Math.floor(along), stops.length - 2);
  return mix(stops[stop], stops[stop + 1], along - stop);
}

export function mix(a: Rgb, b: Rgb, share: number): Rgb {
  const between = (i: 0 | 1 | 2) => a[i] + (b[i] - a[i]) * share;
  return [between(0), between(1), between(2)];
}
