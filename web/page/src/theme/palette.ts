import { recall } from "../state/storage";
import type { Color, Shape } from "../scene/draw-list";

export const THEMES = ["light", "dark", "projector"] as const;
export type Theme = (typeof THEMES)[number];

/** What a visitor can ask for: a theme, or that of the system. */
export const THEME_CHOICES = ["system", ...THEMES] as const;
export type ThemeChoice = (typeof THEME_CHOICES)[number];

/** The mark of each estimator, in the scene, the plots and the text. */
export const MARKS: Record<string, Shape> = {
  kf: "ring",
  ortho: "square",
  "uc-kf": "triangle",
  "et-kf": "diamond",
  eskf: "disc",
  "eskf-raw": "cross",
};

/** The design tokens the canvases need, read from the style sheet so that they are written once. */
export interface Palette {
  readonly theme: Theme;
  /** How much heavier lines are drawn: 1, or more on a projector. */
  readonly weight: number;
  readonly fontSize: number;
  css(token: string): string;
  rgba(token: string, alpha?: number): Color;
}

export function readPalette(theme: Theme): Palette {
  const style = getComputedStyle(document.documentElement);
  const cache = new Map<string, string>();
  const css = (token: string): string => {
    const known = cache.get(token) ?? style.getPropertyValue(`--${token}`).trim();
    cache.set(token, known);
    return known;
  };
  return {
    theme,
    weight: Number(css("line-weight")),
    fontSize: parseFloat(style.fontSize),
    css,
    rgba: (token, alpha = 1) => parseHex(css(token), alpha),
  };
}

/** `#rrggbb`, or the `#rgb` a style sheet is shortened to, as numbers in 0..1. */
export function parseHex(hex: string, alpha: number): Color {
  const digits = hex.slice(1);
  const full = digits.length === 3 ? [...digits].map((digit) => digit + digit).join("") : digits;
  const value = parseInt(full, 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255, alpha];
}

/** What the address asks for, else what was chosen at the last visit. */
export function initialTheme(): ThemeChoice {
  const wanted = new URLSearchParams(location.search).get("theme") ?? recall("theme");
  return THEME_CHOICES.find((choice) => choice === wanted) ?? "system";
}

export function themeOf(choice: ThemeChoice, systemIsDark: boolean): Theme {
  if (choice !== "system") return choice;
  return systemIsDark ? "dark" : "light";
}

/** The browser's own bars take the colour of the header. */
export function applyTheme(theme: Theme): void {
  document.documentElement.dataset["theme"] = theme;
  const surface = getComputedStyle(document.documentElement).getPropertyValue("--surface").trim();
  document.querySelector("meta[name=theme-color]")?.setAttribute("content", surface);
}
