import { completeIndoor, indoorModule, validateIndoor } from "../../engine";
import type { Family } from "../../family";
import type { IndoorScenario } from "../../generated/IndoorScenario";

/** What only these documents have; a document that leaves all of them out names its lab. */
const MARKS: readonly (keyof IndoorScenario)[] = ["beacons", "transmitters", "imu", "ranging", "filters"];

/** A body with an IMU and three transmitters, ranged from beacons; it starts at the origin. */
export const indoor: Family<IndoorScenario> = {
  name: "indoor",
  anchor: "beacon",
  body: "body",
  load: () => indoorModule.load(),
  claims: (document) => MARKS.some((key) => key in document),
  validate: validateIndoor,
  complete: completeIndoor,
  room: ({ beacons, transmitters }) => ({
    dimension: 3,
    anchors: beacons,
    movable: true,
    start: [0, 0, 0],
    body: transmitters,
  }),
  withAnchors: (scenario, anchors) => ({ ...scenario, beacons: anchors.map((anchor) => [...anchor]) }),
  withoutAnchors(scenario, indices) {
    const beacons = scenario.beacons.filter((_, index) => !indices.includes(index));
    return beacons.length > 0 ? { ...scenario, beacons } : withDefaultBeacons(scenario);
  },
};

/** To the document no beacons mean four, at corners around its path. A scenario that is refused anyway stays as it is. */
export function withDefaultBeacons(scenario: IndoorScenario): IndoorScenario {
  const without = { ...scenario, beacons: [] };
  if (validateIndoor(without).length > 0) return scenario;
  return { ...scenario, beacons: completeIndoor(without).beacons };
}
