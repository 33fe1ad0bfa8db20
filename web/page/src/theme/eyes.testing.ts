import { filterDeficiencyDeuter, filterDeficiencyProt, filterDeficiencyTrit, type Rgb } from "culori";
import sheet from "./tokens.css?raw";

/** Complete loss of one kind of receptor, after Machado, Oliveira and Fernandes (2009). */
export type Eye = (color: Rgb) => Rgb;
export const EYES: Record<string, Eye> = {
  "three receptors": (color) => color,
  protanopia: filterDeficiencyProt(1) as Eye,
  deuteranopia: filterDeficiencyDeuter(1) as Eye,
  tritanopia: filterDeficiencyTrit(1) as Eye,
};

/** The colours and plain numbers of a theme, as the style sheet writes them. */
export function tokensOf(theme: string): Record<string, string> {
  const block = sheet.split(`:root[data-theme="${theme}"] {`)[1]?.split("}")[0] ?? "";
  return Object.fromEntries(
    [...block.matchAll(/--([\w-]+): (#[0-9a-f]{6}|[\d.]+);/g)].map((match) => [match[1], match[2]]),
  );
}
