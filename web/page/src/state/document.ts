import type { SceneDocument } from "../family";
import { type Lab, labOf } from "../lab";
import { decodeLink } from "./link";

/** No scenario is this long; a film dropped by mistake is not read into memory. */
const MAX_FILE_BYTES = 1024 * 1024;

/** Its message is a sentence for the student. */
export class DocumentError extends Error {}

/** What reading the document needs did not come: nothing is known against the document itself. */
export class NotLoadedError extends DocumentError {}

/** The scenario a document from outside holds; `source` names it in sentences: “This link”, “The file room.json”. */
export async function readDocument(
  document: unknown,
  source: string,
  labs: readonly Lab[],
): Promise<SceneDocument> {
  const lab = labFor(document, source, labs);
  await lab.family.load?.().catch((error: unknown) => {
    throw new NotLoadedError(notLoaded(lab, error));
  });
  const [problem] = lab.family.validate(document);
  if (problem) throw new DocumentError(`${source} holds a scenario that does not work: ${problem.message}.`);
  return lab.family.complete(document);
}

/** What is no document at all goes to the first lab: its engine says what is wrong with it. */
function labFor(document: unknown, source: string, labs: readonly Lab[]): Lab {
  if (typeof document !== "object" || document === null) return labs[0];
  const lab = labOf(document, labs);
  if (lab) return lab;
  const { view } = document as Partial<SceneDocument>;
  throw new DocumentError(`${source} is for the lab “${view?.["lab"]}”, which this page does not have.`);
}

/** The scenario of a link, `#v1.…`. */
export async function readLink(hash: string, labs: readonly Lab[]): Promise<SceneDocument> {
  return readDocument(await decodeLink(hash), "This link", labs);
}

/** The scenario of a JSON text. */
export async function readText(text: string, source: string, labs: readonly Lab[]): Promise<SceneDocument> {
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

/** Why a lab is not there. */
export function notLoaded(lab: Lab, error: unknown): string {
  return `The lab ${lab.title} could not be loaded (${sentenceOf(error).replace(/\.$/, "")}).`;
}
