import { formatPoint } from "../../controls/format";
import { nextAt } from "../../engine";
import type { NextPlace } from "../../generated/NextPlace";
import type { Scenario } from "../../scenario";
import { addAnchors } from "../../rigid-body/anchor-edits";
import { formatValue } from "./placement";

/** What a field shows: a bound of the body, or what one more anchor would be worth. */
export type Shown = "position" | "orientation" | "next_anchor";

export function shownOf({ subject, quantity }: Scenario["field"]): Shown {
  return subject === "next_anchor" ? subject : quantity;
}

/** The scenario with a field that shows this. */
export function withShown(scenario: Scenario, shown: Shown): Scenario {
  const change =
    shown === "next_anchor" ? ({ subject: shown } as const) : ({ subject: "body", quantity: shown } as const);
  return { ...scenario, field: { ...scenario.field, ...change } };
}

/** The choice as an edit names it. */
export function shownSentence(shown: Shown): string {
  return shown === "next_anchor" ? "Field: best next anchor" : `Field: bound of the ${shown}`;
}

/** Whether the field's numbers are angles; else they are lengths. */
export function inAngles({ field, placement }: Pick<Scenario, "field" | "placement">): boolean {
  return field.subject === "next_anchor"
    ? placement.target === "orientation"
    : field.quantity === "orientation";
}

/** What the field's colours mean. */
export function fieldTitle({ field, placement }: Pick<Scenario, "field" | "placement">): string {
  return field.subject === "next_anchor"
    ? `Bound of the ${placement.target}, one more anchor here`
    : `Bound of the ${field.quantity}`;
}

/** What one more anchor is worth at a point; null where the engine has nothing to tell. */
export function nextPlaceAt(scenario: Scenario, point: readonly number[]): NextPlace | null {
  try {
    return nextAt(scenario, point);
  } catch {
    return null;
  }
}

/** "7.14 mm now, 6.42 mm with one more anchor here". */
export function gain({ before, after, unit }: NextPlace): string {
  return `${formatValue(before, unit)} now, ${formatValue(after, unit)} with one more anchor here`;
}

export function toldNext(next: NextPlace | null): string[] {
  return next ? [`Best next anchor at ${roundedPoint(next)}: ${gain(next)}.`] : [];
}

export function roundedPoint({ point }: Pick<NextPlace, "point">): string {
  return formatPoint(point.map((value) => Number(value.toPrecision(3))));
}

/** The scenario with an anchor there. Anchors that were drawn anew stay from now on. */
export function withNextAnchor(scenario: Scenario, { point }: NextPlace): Scenario {
  return addAnchors({ ...scenario, redraw_anchors: null }, [point]);
}
