import * as engine from "../engine";
import { type Lab, labOf } from "../lab";
import type { Scenario } from "../scenario";
import { decodeLink } from "./link";

/** No scenario is this long; a film dropped by mistake is not read into memory. */
const MAX_FILE_BYTES = 1024 * 1024;

/** Its message is a sentence for the student. */
export class DocumentError extends Error {}

/** The scenario a document from outside holds; `source` names it in sentences: “This link”, “The file room.json”. */
export function readDocument(document: unknown, source: string, labs: readonly Lab[]): Scenario {
  const [problem] = engine.validate(document);
  if (problem) throw new DocumentError(`${source} holds a scenario that does not work: ${problem.message}.`);
  const scenario = engine.complete(document);
  if (!labOf(scenario, labs))
    throw new DocumentError(
      `${source} is for the lab “${scenario.view?.["lab"]}”, which this page does not have.`,
    );
  return scenario;
}

/** The scenario of a link, `#v1.…`. */
export async function readLink(hash: string, labs: readonly Lab[]): Promise<Scenario> {
  return readDocument(await decodeLink(hash), "This link", labs);
}

/** The scenario of a JSON text. */
export function readText(text: string, source: string, labs: readonly Lab[]): Scenario {
  let document: unknown;
  try {
    document = JSON.parse(text);
  } catch {
    throw new DocumentError(`${source} is no JSON document.`);
  }
  return readDocument(document, source, labs);
}

export async function textOf(file: File): Promise<string> {
  if (file.size > MAX_FILE_BYTES)
    throw new DocumentError(
      `The file ${file.name} has ${file.size} bytes; a scenario has at most ${MAX_FILE_BYTES}.`,
    );
  return file.text();
}

export function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
