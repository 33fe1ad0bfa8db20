import type { KinematicsName } from "../../../generated/KinematicsName";
import { switched } from "../../../state/edit";
import { estimatorOf, ORDER, SENSING_FIRST } from "../estimators";

/** The estimators without those that read accelerometers, or with those that the preset has of them. */
export function withAccelerometers(
  enabled: readonly KinematicsName[],
  wanted: boolean,
  preset: readonly KinematicsName[] | undefined,
): KinematicsName[] {
  if (!wanted) return enabled.filter((name) => !estimatorOf(name).senses);
  const usual = preset?.filter((name) => estimatorOf(name).senses) ?? [];
  return switched(enabled, usual.length > 0 ? usual : SENSING_FIRST, true, ORDER);
}
