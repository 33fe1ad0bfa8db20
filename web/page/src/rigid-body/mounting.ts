import { formatReading } from "../controls/format";
import { mountingCloud } from "../engine";
import type { Scenario } from "../scenario";
import { lift, type Vec3 } from "../scene/geometry";

/** Trials whose sensors are shown: as many places of each. */
export const CLOUD_TRIALS = 48;

const clouds = new WeakMap<Scenario, readonly Vec3[]>();

/** Places in the body frame where the sensors may sit; none while they sit exactly where they are said to. */
export function cloudOf(scenario: Scenario): readonly Vec3[] {
  if (scenario.mounting_sigma === 0) return [];
  const known = clouds.get(scenario) ?? placesOf(scenario);
  clouds.set(scenario, known);
  return known;
}

function placesOf(scenario: Scenario): Vec3[] {
  const numbers = Array.from(mountingCloud(scenario, CLOUD_TRIALS));
  const { dimension } = scenario;
  return Array.from({ length: numbers.length / dimension }, (_, index) =>
    lift(numbers.slice(index * dimension, (index + 1) * dimension)),
  );
}

/** The position that least squares finds is off by this, however good the ranges are (one standard deviation), m. */
export function positionFloor({ mounting_sigma, dimension, sensors }: Scenario): number {
  return mounting_sigma * Math.sqrt(dimension / sensors.length);
}

export function onMounting(scenario: Scenario): { text: string; warning: boolean } {
  if (scenario.mounting_sigma === 0)
    return {
      text: "Sensors sit where the table says. An error puts them elsewhere in every trial; no estimator is told.",
      warning: false,
    };
  const text = `Every trial puts each sensor a little elsewhere, and neither estimators nor bounds know of it: positions of single epochs stay about ${formatReading(positionFloor(scenario))} m off, however good the ranges.`;
  return { text, warning: true };
}

/** The error in words; nothing where there is none. */
export function toldMounting({ mounting_sigma }: Scenario): string[] {
  if (mounting_sigma === 0) return [];
  return [
    `Sensors sit ${formatReading(mounting_sigma)} m off their places in each coordinate (one sigma); estimators and bounds do not know of it.`,
  ];
}
