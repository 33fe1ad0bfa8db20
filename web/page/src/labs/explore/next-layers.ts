import type { Label, Layer } from "../../scene/input";
import { lift } from "../../scene/geometry";
import { formatValue } from "./placement";
import type { ExploreRun } from "./run";

/** Where one more anchor helps most. */
export const nextMark: Layer<ExploreRun> = ({ run, palette }, out) => {
  if (!run?.next) return;
  const at = lift(run.next.point);
  out.point(at, 11, palette.rgba("ground"), "disc");
  out.point(at, 10, palette.rgba("accent"), "ring");
  out.point(at, 5, palette.rgba("accent"), "square");
};

export function nextLabels({ run }: { run: ExploreRun | null }): Label[] {
  if (!run?.next) return [];
  const { point, before, after, unit } = run.next;
  const text = `best next anchor: ${formatValue(before, unit)} now, ${formatValue(after, unit)} here`;
  return [{ id: "next anchor", at: lift(point), text, kind: "name" }];
}
