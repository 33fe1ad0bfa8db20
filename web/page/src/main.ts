import "uplot/dist/uPlot.min.css";
import "./theme/tokens.css";
import "./theme/base.css";
import { mount } from "svelte";
import App from "./App.svelte";
import { loadEngine } from "./engine";
import { LABS } from "./labs";
import { readLink, sentenceOf, Session } from "./state/session.svelte";
import { Workspace } from "./state/workspace.svelte";
import { applyTheme, initialTheme } from "./theme/palette";

async function start(): Promise<void> {
  const target = document.getElementById("app");
  if (!target) throw new Error("index.html has no element with the id app");
  const theme = initialTheme();
  applyTheme(theme);
  try {
    await loadEngine();
    const session = await openSession();
    mount(App, { target, props: { workspace: new Workspace(session, theme) } });
  } catch (error) {
    target.textContent = `The page could not start: ${sentenceOf(error)}`;
  }
}

/** The scenario of the address; where there is none, or a bad one, the first preset. */
async function openSession(): Promise<Session> {
  const first = LABS[0].preset(LABS[0].firstPreset);
  if (location.hash.length <= 1) return new Session(first, LABS);
  try {
    return new Session(await readLink(location.hash, LABS), LABS);
  } catch (error) {
    const session = new Session(first, LABS);
    session.refusal = `${sentenceOf(error)} The default scene is shown instead.`;
    return session;
  }
}

void start();
