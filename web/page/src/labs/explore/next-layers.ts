import type { NextPlace } from "../../generated/NextPlace";
import type { DrawList } from "../../scene/draw-list";
import type { Label, SceneInput } from "../../scene/input";
import { lift } from "../../scene/geometry";
import { formatValue } from "./placement";

/** Where one more anchor helps most. */
export function nextMark(
  next: NextPlace | null,
  { palette }: Pick<SceneInput, "palette">,
  out: DrawList,
): void {
  if (!next) return;
  const at = lift(next.point);
  out.point(at, 11, palette.rgba("ground"), "disc");
  out.point(at, 10, palette.rgba("accent"), "ring");
  out.point(at, 5, palette.rgba("accent"), "square");
}

export function nextLabels(next: NextPlace | null): Label[] {
  if (!next) return [];
  const { point, before, after, unit } = next;
  const text = `best next anchor: ${formatValue(before, unit)} now, ${formatValue(after, unit)} here`;
  return [{ id: "next anchor", at: lift(point), text, kind: "name" }];
}
