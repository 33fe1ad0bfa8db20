import type { SceneDocument } from "../family";
import type { Lab } from "../lab";
import { readLink, readText, sentenceOf } from "./document";
import { AUTOSAVE } from "./keeper";
import { Session } from "./session.svelte";
import { forget, recall } from "./storage";

/** The session a visit starts with: the link's scene, else the last one of this browser, else the first preset. */
export async function startSession(hash: string, labs: readonly Lab[]): Promise<Session> {
  const kept = await readKept(labs);
  const scenario = kept.scenario ?? labs[0].preset(labs[0].firstPreset);
  if (hash.length > 1) {
    try {
      return new Session(await readLink(hash, labs), labs);
    } catch (error) {
      const shown = kept.scenario ? "Your last scene" : "The default scene";
      return refused(new Session(scenario, labs), `${sentenceOf(error)} ${shown} is shown instead.`);
    }
  }
  const session = new Session(scenario, labs);
  if (kept.sentence) return refused(session, kept.sentence);
  session.restored = kept.scenario !== null;
  return session;
}

interface Kept {
  scenario: SceneDocument | null;
  /** Why what was kept cannot be used. */
  sentence: string | null;
}

async function readKept(labs: readonly Lab[]): Promise<Kept> {
  const text = recall(AUTOSAVE);
  if (text === null) return { scenario: null, sentence: null };
  try {
    const scenario = await readText(text, "The scene kept from your last visit", labs);
    return { scenario: isFirst(scenario, labs) ? null : scenario, sentence: null };
  } catch (error) {
    forget(AUTOSAVE);
    return { scenario: null, sentence: `${sentenceOf(error)} The default scene is shown instead.` };
  }
}

/** Nothing is restored where the last scene is the one that opens anyway. */
function isFirst(scenario: SceneDocument, labs: readonly Lab[]): boolean {
  return JSON.stringify(scenario) === JSON.stringify(labs[0].preset(labs[0].firstPreset));
}

function refused(session: Session, sentence: string): Session {
  session.refuse(sentence);
  return session;
}
