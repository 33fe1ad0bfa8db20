import { formatNumber, formatPoint, formatReading } from "../../controls/format";
import { asSentence } from "../../words";
import { arrowScale, errorAt, errorScale, type Input } from "./drawn";
import { estimatorOf } from "./estimators";
import { gaugeOf, isIdentity } from "./gauge";
import { arrowSeconds } from "./hints";

/** How to read the scene: how many times larger errors are drawn, and in what time arrows are gone along. */
export function note(input: Input): string {
  const { run, scenario } = input;
  if (!run) return "";
  const [errors, ofArrows] = [errorScale(input), arrowScale(input)].map((times) => formatNumber(times));
  const seconds = formatNumber(arrowSeconds(scenario), 3);
  const gauge = isIdentity(gaugeOf(scenario)) ? "" : "; turned by the gauge";
  return `Errors × ${errors}, at arrows × ${ofArrows}; arrows: ${seconds} s${gauge}`;
}

/** The scene in words. */
export function told(input: Input): string[] {
  const { run, step, scenario } = input;
  if (!run) return [];
  const gauge = gaugeOf(scenario);
  return [
    ...(run.trial.missing > 0 ? [`${run.trial.missing} distances are missing.`] : []),
    ...(isIdentity(gauge)
      ? []
      : [
          `The gauge turns the network by ${formatNumber(gauge.degrees)} degrees${gauge.mirrored ? ", mirrored," : ""} and shifts it by ${formatPoint(gauge.shift)}.`,
        ]),
    ...run.trial.estimators.map((found) => {
      const { label } = estimatorOf(found.name);
      if (found.failure !== null) return `${label}: ${asSentence(found.failure)}`;
      const errors = run.anchors.flatMap((_, node) => errorAt(run, found, step, node) ?? []);
      if (errors.length === 0) return `${label} has no positions at this step.`;
      const root = Math.sqrt(
        errors.reduce((sum, error) => sum + error * error, 0) / (run.anchors.length * run.dimension),
      );
      return `${label} is ${formatReading(root)} m off for each coordinate at this step.`;
    }),
  ];
}
