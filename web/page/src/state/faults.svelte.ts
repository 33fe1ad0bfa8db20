import { version } from "../../package.json";
import type { SceneDocument } from "../family";
import { sentenceOf } from "./document";
import { addressOf } from "./link";

/** Browsers tell this as an error where a layout settles one frame later; nothing is wrong. */
const HARMLESS = /^ResizeObserver loop/;

/** Errors nobody foresaw: the last one is told, and can be reported with all that is needed to repeat it. */
export class Faults {
  last: unknown = $state.raw(null);

  note(error: unknown): void {
    if (!HARMLESS.test(sentenceOf(error))) this.last = error ?? "an error without a word";
  }

  dismiss(): void {
    this.last = null;
  }
}

/** What a maintainer needs: the scenario as a link, the browser, the version, the error. */
export async function reportOf(error: unknown, scenario: SceneDocument): Promise<string> {
  return [
    `rangelab ${version}`,
    `Scenario: ${await addressOf(scenario).catch(sentenceOf)}`,
    `Browser: ${navigator.userAgent}, window ${innerWidth} x ${innerHeight}`,
    `Error: ${traceOf(error)}`,
  ].join("\n");
}

function traceOf(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const trace = error.stack ?? error.message;
  return error.cause === undefined ? trace : `${trace}\nCause: ${traceOf(error.cause)}`;
}
