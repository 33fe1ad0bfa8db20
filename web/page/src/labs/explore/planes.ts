import { formatNumber } from "../../controls/format";
import type { FieldPlane } from "../../generated/FieldPlane";
import { boxOf } from "../../rigid-body/arrangements";
import type { Scenario } from "../../scenario";

/** The planes that a field can lie in. */

type PlaneKind = FieldPlane["kind"];

const LABELS: Record<PlaneKind, string> = {
  level: "level, through the body",
  horizontal: "level, at a height",
  vertical: "upright",
  body: "the body's own x and y",
};

/** The plane has only itself. */
export function planeOptions(dimension: number): { value: PlaneKind; label: string }[] {
  const kinds = Object.keys(LABELS) as PlaneKind[];
  return kinds
    .filter((kind) => dimension === 3 || kind === "level")
    .map((value) => ({ value, label: LABELS[value] }));
}

/** What a plane starts as: through the middle of the anchors or the body. */
export function firstPlane(scenario: Scenario, kind: PlaneKind): FieldPlane {
  if (kind === "horizontal") {
    const { least, most } = boxOf(scenario.anchors);
    return { kind, height: rounded((least[2] + most[2]) / 2) };
  }
  if (kind === "vertical") return { kind, heading: 0, offset: rounded(scenario.start.position[1]) };
  return { kind };
}

export function planeSentence(kind: PlaneKind, scenario: Scenario): string {
  const at =
    kind === "level" && scenario.dimension === 3 ? ` at ${formatNumber(scenario.start.position[2])} m` : "";
  return `Plane of the field: ${LABELS[kind]}${at}`;
}

function rounded(value: number): number {
  return Number(value.toPrecision(3)) + 0;
}
