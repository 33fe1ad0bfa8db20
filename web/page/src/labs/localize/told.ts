import { DEGREES_PER_RADIAN, formatNumber, formatReading } from "../../controls/format";
import { positionFloor } from "../../rigid-body/mounting";
import type { Scenario } from "../../scenario";
import type { SceneInput } from "../../scene/input";
import { asSentence, countOf, joined, startOf } from "../../words";
import { unseenMirrors } from "./layers";
import { BOUND_LOOKS, boundOf, lookOf } from "./localizers";
import type { LocalizeRun } from "./run";

/** Fewer mirrored bodies than this share are an accident. */
const OFTEN = 0.01;
/** A localizer this near its bound is at it. */
const AT_BOUND = 1.1;
/** More names than these are counted instead. */
const MOST_NAMES = 3;

type Report = LocalizeRun["report"]["estimators"][number];
const namesOf = (reports: readonly Report[]) => joined(reports.map(({ name }) => lookOf(name)));
const rateOf = ({ points: [point] }: Report) => point.reflection_rate?.value ?? 0;
const angleOf = ({ points: [point] }: Report) => point.rms_angle?.value ?? Infinity;

/** What the clouds show, in a few sentences. */
export function describe(run: LocalizeRun): string {
  const { report } = run;
  if (report.estimators.length === 0) return "No localizer is switched on.";
  return [nearest(run), mirroring(report.estimators), failing(run)].filter((text) => text !== "").join(" ");
}

/** The localizer with the least error of the orientation, beside the bound for what it knows. */
function nearest({ report }: LocalizeRun): string {
  const best = report.estimators.reduce((one, other) => (angleOf(other) < angleOf(one) ? other : one));
  const [found] = best.points;
  if (!found.rms_angle || !found.rmse_position) return "";
  const label = lookOf(best.name).label;
  const error = errorText(found.rms_angle.value, found.rmse_position.value);
  const bound = report.bounds.find(({ name }) => name === boundOf(best.name));
  const least = bound?.points[0];
  const over = `Over ${report.trials} trials ${label} is nearest: ${error} off`;
  if (!bound || !least?.angle || !least.position) return `${over}; no bound exists here.`;
  const ratio = found.rms_angle.value / least.angle.value;
  const verdict =
    ratio < AT_BOUND ? "it is at its bound" : `${formatReading(ratio)} times its bound in orientation`;
  const limit = `${BOUND_LOOKS[bound.name].label}: ${errorText(least.angle.value, least.position.value)}`;
  return `${over}; ${verdict} (${limit}).`;
}

function mirroring(estimators: readonly Report[]): string {
  const often = estimators.filter((entry) => rateOf(entry) >= OFTEN);
  if (often.length === 0) return "";
  const rates = often.map(rateOf);
  const [least, most] = [Math.min(...rates), Math.max(...rates)].map((rate) => formatReading(100 * rate));
  const share = least === most ? `${most} %` : `${least} to ${most} %`;
  const names = often.length > MOST_NAMES ? startOf(`${countOf(often.length)} localizers`) : namesOf(often);
  return `${names} ${often.length === 1 ? "mirrors" : "mirror"} the body in ${share} of the trials.`;
}

function failing({ report, snapshot }: LocalizeRun): string {
  const failed = report.estimators.filter(({ points: [point] }) => point.failures > 0);
  const [first] = failed;
  if (!first) return "";
  const count = `${first.points[0].failures} of ${report.trials} trials`;
  const reason = snapshot.estimators.find(({ failure }) => failure !== null)?.failure;
  const names = namesOf(failed);
  const verb = failed.length === 1 ? "has" : "have";
  return `${names} ${verb} no estimate in ${count}${reason ? `: ${asSentence(reason)}` : "."}`;
}

/** How to read the scene. */
export function note({ run, uncertainty, scenario }: SceneInput<LocalizeRun, Scenario>): string {
  if (!run) return "";
  const [dots, tips] = [uncertainty.position, uncertainty.orientation];
  const of = [...(dots ? ["positions"] : []), ...(tips ? ["tips of the axes"] : [])].join(" and ");
  const drawn = `Bodies: trial ${formatNumber(run.trial)}`;
  const redrawn = scenario.redraw_anchors ? ["anchors differ from trial to trial"] : [];
  const mirrors =
    unseenMirrors(run).length > 0
      ? ["dashed: the first mirrored body"]
      : run.estimates.some(({ estimate }) => estimate.reflected)
        ? ["dashed: mirrored"]
        : [];
  return [drawn, ...(of ? [`dots: ${of} in ${run.report.trials} trials`] : []), ...mirrors, ...redrawn].join(
    "; ",
  );
}

/** The scene in words. */
export function told({ run, scenario }: SceneInput<LocalizeRun, Scenario>): string[] {
  if (!run) return [];
  return [
    ...run.snapshot.estimators.map(({ name, errors, reflected, failure }) => {
      const { label } = lookOf(name);
      if (failure !== null) return `${label}: ${asSentence(failure)}`;
      if (!errors) return `${label} places sensors and no body.`;
      const how = reflected ? ", mirrored" : "";
      return `${label} ${errorText(errors.angle, errors.position)} from the body${how}.`;
    }),
    ...unseenMirrors(run).map(({ name, mirrored }) => {
      const count = mirrored.filter(Boolean).length;
      return `${lookOf(name).label} mirrors the body in ${count} of ${mirrored.length} trials.`;
    }),
    ...(scenario.mounting_sigma > 0 ? [onMounting(scenario).text] : []),
  ];
}

/** What a topology off its places costs here, where the bounds and the total least squares know of it. */
export function onMounting(scenario: Scenario): { text: string; warning: boolean } {
  if (scenario.mounting_sigma === 0)
    return {
      text: "Sensors sit where the table says. An error puts them elsewhere in every trial.",
      warning: false,
    };
  const floor = formatReading(positionFloor(scenario));
  return {
    text: `Every trial puts each sensor a little elsewhere: positions stay about ${floor} m off, however good the ranges. Bounds and OUC-TLS know of it.`,
    warning: true,
  };
}

function errorText(angle: number, position: number): string {
  return `${formatReading(angle * DEGREES_PER_RADIAN)}° and ${formatReading(position)} m`;
}
