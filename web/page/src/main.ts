import "uplot/dist/uPlot.min.css";
import "./theme/tokens.css";
import "./theme/base.css";
import { mount } from "svelte";
import App from "./App.svelte";
import { trackModule } from "./engine";
import NoStart from "./frame/NoStart.svelte";
import { LABS } from "./labs";
import { startSession } from "./state/start";
import { Workspace } from "./state/workspace.svelte";
import { applyTheme, initialTheme, themeOf } from "./theme/palette";

async function start(): Promise<void> {
  const target = document.getElementById("app");
  if (!target) throw new Error("index.html has no element with the id app");
  const theme = initialTheme();
  applyTheme(themeOf(theme, matchMedia("(prefers-color-scheme: dark)").matches));
  try {
    await trackModule.load();
    const session = await startSession(location.hash, LABS);
    mount(App, { target, props: { workspace: new Workspace(session, theme) } });
  } catch (error) {
    mount(NoStart, { target, props: { error } });
  }
}

void start();
