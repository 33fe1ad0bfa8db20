import type { SceneDocument } from "../family";
import type { Lab } from "../lab";
import { NotLoadedError, readLink, readText, sentenceOf } from "./document";
import { AUTOSAVE } from "./keeper";
import { Session } from "./session.svelte";
import { forget, recall } from "./storage";

/** The session a visit starts with: the link's scene, else the last one of this browser, else the first preset. */
export async function startSession(hash: string, labs: readonly Lab[]): Promise<Session> {
  if (hash.length <= 1) return startFromKept(labs);
  try {
    return new Session(await readLink(hash, labs), labs);
  } catch (error) {
    const { scenario } = await readKept(labs);
    const shown = scenario ? "Your last scene" : "The default scene";
    return toldAt(labs, scenario, error, `${sentenceOf(error)} ${shown} is shown instead`);
  }
}

async function startFromKept(labs: readonly Lab[]): Promise<Session> {
  const { scenario, error } = await readKept(labs);
  if (error) return toldAt(labs, null, error, `${sentenceOf(error)} The default scene is shown instead`);
  const session = startAt(labs, scenario);
  session.restored = scenario !== null;
  return session;
}

interface Kept {
  scenario: SceneDocument | null;
  /** Why what was kept cannot be used. */
  error: unknown;
}

/** What cannot be read is forgotten; what could not be read only now stays for the next visit. */
async function readKept(labs: readonly Lab[]): Promise<Kept> {
  const text = recall(AUTOSAVE);
  if (text === null) return { scenario: null, error: null };
  try {
    const scenario = await readText(text, "The scene kept from your last visit", labs);
    return { scenario: isFirst(scenario, labs) ? null : scenario, error: null };
  } catch (error) {
    if (!(error instanceof NotLoadedError)) forget(AUTOSAVE);
    return { scenario: null, error };
  }
}

/** Nothing is restored where the last scene is the one that opens anyway. */
function isFirst(scenario: SceneDocument, labs: readonly Lab[]): boolean {
  return JSON.stringify(scenario) === JSON.stringify(firstOf(labs));
}

function firstOf([first]: readonly Lab[]): SceneDocument {
  return first.preset(first.firstPreset);
}

function startAt(labs: readonly Lab[], scenario: SceneDocument | null): Session {
  return new Session(scenario ?? firstOf(labs), labs);
}

/** A session that says why it starts elsewhere. The address stays where the page can be loaded anew from it. */
function toldAt(
  labs: readonly Lab[],
  scenario: SceneDocument | null,
  error: unknown,
  sentence: string,
): Session {
  const session = startAt(labs, scenario);
  if (error instanceof NotLoadedError) session.refusal = `${sentence}; reload the page to try again.`;
  else session.refuse(`${sentence}.`);
  return session;
}
