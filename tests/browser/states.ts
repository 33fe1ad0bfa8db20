import { expect } from "@playwright/test";
import { Lab } from "./lab";

export const THEMES = ["light", "dark", "projector"] as const;
export type Theme = (typeof THEMES)[number];
export const SIZES = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
] as const;
export type Size = (typeof SIZES)[number];

/** Something that a visitor can have on the screen: how to get there from the page as it opens. */
export interface State {
  readonly name: string;
  /** Opens with this preset; without one as the page does by itself. */
  readonly preset?: string;
  prepare(lab: Lab): Promise<void>;
}

/** Every state is looked at in the pictures and judged by axe: a new part of the page adds its own line. */
export const STATES: readonly State[] = [
  { name: "start", prepare: async () => undefined },
  ...["planar", "tracking-paper", "three-anchors"].map((preset) => ({
    name: preset,
    preset,
    prepare: async () => undefined,
  })),
  { name: "anchor chosen", prepare: (lab) => lab.choose(2) },
  { name: "groups open", prepare: (lab) => lab.openGroups() },
  { name: "warned choices", prepare: chooseDangerously },
  { name: "drawn path", prepare: drawPath },
  { name: "NEES shown", prepare: showNees },
  { name: "refusal", prepare: refuse },
  { name: "help", prepare: (lab) => openDialog(lab, "Help") },
  { name: "data table", prepare: (lab) => lab.plotMenu("Orientation error", "Data table") },
  { name: "plot menu", prepare: (lab) => lab.plotMenu("Orientation error") },
  { name: "Monte-Carlo", prepare: (lab) => averages(lab) },
  { name: "NIS outside", preset: "overconfident", prepare: (lab) => innovations(lab) },
  { name: "ET budget", preset: "tracking-paper", prepare: (lab) => averages(lab, "ET budget") },
  { name: "Anchor draws", preset: "tracking-paper-redrawn", prepare: (lab) => drawn(lab) },
  { name: "plot enlarged", prepare: (lab) => enlarge(lab) },
  { name: "sheet open", prepare: (lab) => lab.openSheet() },
  { name: "export menu", prepare: openExport },
  { name: "parts put away", prepare: putAway },
  { name: "scene restored", prepare: restore },
  { name: "fault told", prepare: fault },
  { name: "Localize", prepare: (lab) => localize(lab) },
  { name: "Localize, mirrored", preset: "localization-paper", prepare: localizeMirrored },
  { name: "Localize, groups open", prepare: localizeOpen },
  { name: "Localize, planar", preset: "planar", prepare: (lab) => localize(lab) },
  { name: "Explore", prepare: (lab) => explore(lab) },
  { name: "Explore, groups open", prepare: exploreOpen },
  { name: "Explore, next anchor", prepare: exploreNext },
  { name: "Explore, coplanar", preset: "coplanar-ceiling", prepare: (lab) => explore(lab) },
  { name: "Explore, sensor chosen", prepare: chooseSensor },
  { name: "Explore, planar", preset: "planar", prepare: (lab) => explore(lab) },
  { name: "Explore, handles", prepare: showHandles },
  { name: "Explore, drawings", prepare: openDrawings },
  { name: "Indoor", prepare: (lab) => indoor(lab) },
  { name: "Indoor, stairs", prepare: (lab) => indoor(lab, "A staircase") },
  { name: "Indoor, matched", prepare: (lab) => indoor(lab, "Inputs that match the filter") },
  { name: "Indoor, gravity", prepare: (lab) => indoor(lab, "Gravity on the stairs") },
  { name: "Indoor, all filters", prepare: indoorAll },
  { name: "Indoor, groups open", prepare: indoorOpen },
  { name: "Indoor, beacon chosen", prepare: indoorChosen },
  { name: "Indoor, Monte-Carlo", prepare: indoorAverages },
  { name: "Anchorless", prepare: (lab) => anchorless(lab) },
  { name: "Anchorless, four nodes", prepare: (lab) => anchorless(lab, "Four nodes") },
  { name: "Anchorless, space", prepare: (lab) => anchorless(lab, "Twelve nodes in space") },
  { name: "Anchorless, gauge", prepare: anchorlessTurned },
  { name: "Anchorless, tip chosen", prepare: anchorlessChosen },
  { name: "Anchorless, groups open", prepare: anchorlessOpen },
  { name: "Anchorless, Monte-Carlo", prepare: (lab) => anchorlessAverages(lab, "Monte-Carlo") },
  { name: "Anchorless, over K", prepare: (lab) => anchorlessAverages(lab, "Over K") },
  { name: "figures", prepare: (lab) => openFigures(lab) },
  { name: "figure computed", prepare: (lab) => computeFigure(lab, "tracking-2", TRACKING_2) },
  { name: "figure of Indoor", prepare: (lab) => computeFigure(lab, "indoor-9", /Distribution of the RMSE/) },
  { name: "figure of Anchorless", prepare: (lab) => computeFigure(lab, "kinematics-2b", /^Fig. 2b/, "20") },
  { name: "figure claims", prepare: showClaims },
];

/** The page in that state, theme and size. */
export async function enter(lab: Lab, state: State): Promise<void> {
  if (state.preset) await lab.openPreset(state.preset);
  await state.prepare(lab);
}

/** Explore with its boxes, a wall and a corner that is chosen. */
async function showHandles(lab: Lab): Promise<void> {
  await explore(lab);
  const placement = await lab.openGroup("Placement");
  for (const name of ["Body in a box", "Limit anchors", "Keep-out box"])
    await placement.getByRole("button", { name }).click();
  const availability = await lab.openGroup("Range availability");
  await availability.getByRole("button", { name: "Add a wall" }).click();
  const close = lab.page.getByRole("button", { name: "Close", exact: true });
  if (await close.isVisible()) await close.click();
  await lab.surface.focus();
  for (let i = 0; i < 5; i++) await lab.page.keyboard.press("p");
  await expect(lab.page.getByRole("group", { name: "Selected handle" })).toBeVisible();
}

async function openDrawings(lab: Lab): Promise<void> {
  await explore(lab);
  await lab.page.getByRole("button", { name: "Draw…" }).click();
  await expect(lab.page.getByRole("button", { name: "Draw a wall" })).toBeVisible();
}

async function openFigures(lab: Lab): Promise<void> {
  await lab.page.getByRole("button", { name: "Figures", exact: true }).click();
  await expect(lab.page.getByRole("dialog")).toBeVisible({ timeout: 30_000 });
}

const TRACKING_2 = /RMSE of orientation and position/;

/** A figure by name; where room is short the list of them is a choice, else their titles are buttons. */
async function computeFigure(lab: Lab, name: string, title: RegExp, trials = "40"): Promise<void> {
  await openFigures(lab);
  const dialog = lab.page.getByRole("dialog");
  const choice = dialog.getByRole("combobox", { name: "Figure" });
  if (await choice.isVisible()) await choice.selectOption(name);
  else await dialog.getByRole("button", { name: title }).click();
  await dialog.getByRole("textbox", { name: "Trials" }).fill(trials);
  await dialog.getByRole("button", { name: "Compute" }).click();
  const progress = dialog.getByTestId("figure-progress");
  await expect(progress).toHaveText(/jobs, complete/, { timeout: 120_000 });
}

async function showClaims(lab: Lab): Promise<void> {
  await computeFigure(lab, "tracking-2", TRACKING_2);
  await lab.page.getByRole("button", { name: "Save as CSV" }).scrollIntoViewIfNeeded();
}

async function refuse(lab: Lab): Promise<void> {
  await lab.openSheet();
  await lab.type("Noise level σ", "-1");
  await expect(lab.alert).not.toBeEmpty();
}

async function chooseDangerously(lab: Lab): Promise<void> {
  await lab.openGroup("Weights of ranges");
  await lab.pick("Weights", "true");
  await lab.openGroup("Estimator settings");
  await lab.pick("Projected Q", "fed back");
  await lab.pick("Manifold", "O(D)");
}

async function drawPath(lab: Lab): Promise<void> {
  const group = await lab.openGroup("Motion of the body");
  await group.getByLabel("Path", { exact: true }).selectOption({ label: "drawn by hand" });
  await group.getByRole("img").scrollIntoViewIfNeeded();
}

async function showNees(lab: Lab): Promise<void> {
  await lab.page.getByRole("button", { name: "NEES column" }).click();
}

async function openExport(lab: Lab): Promise<void> {
  await lab.page.getByRole("button", { name: "Export" }).click();
  await expect(lab.page.getByRole("button", { name: "Scenario as a file" })).toBeVisible();
}

async function putAway(lab: Lab): Promise<void> {
  for (const name of ["Show plots", "Show panel"]) {
    const button = lab.page.getByRole("button", { name });
    if (await button.isVisible()) await button.click();
  }
}

async function restore(lab: Lab): Promise<void> {
  await lab.openSheet();
  await lab.type("Seed", "7");
  await expect(lab.status).toContainText("Seed set to 7");
  await lab.page.goto(new URL(lab.page.url()).search);
  await expect(lab.page.getByText("Restored your last scene")).toBeVisible();
}

async function fault(lab: Lab): Promise<void> {
  await lab.page.evaluate(() => reportError(new Error("A sentence that tells what went wrong here.")));
  await expect(lab.page.getByRole("button", { name: "Copy report" })).toBeVisible();
}

async function explore(lab: Lab): Promise<void> {
  await lab.page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(lab.page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
}

async function localize(lab: Lab): Promise<void> {
  await lab.page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Localize" }).click();
  await expect(lab.page.getByRole("table", { name: "Errors of the localizers" })).toBeVisible();
  await stopAtFirst(lab);
}

async function localizeMirrored(lab: Lab): Promise<void> {
  await localize(lab);
  await lab.openSheet();
  await lab.type("Signal to noise ζ", "35");
  await lab.pick("Group", "O(D)");
  const close = lab.page.getByRole("button", { name: "Close", exact: true });
  if (await close.isVisible()) await close.click();
  await lab.page.getByRole("button", { name: "Go on" }).click();
  await stopAtFirst(lab);
}

async function localizeOpen(lab: Lab): Promise<void> {
  await localize(lab);
  await lab.openGroups();
  await lab.pick("OUC-TLS assumes", "its own");
  await lab.pick("Loss of ML", "Huber");
}

async function chooseSensor(lab: Lab): Promise<void> {
  await explore(lab);
  await lab.openGroup("Sensors on the body");
  await lab.type("Mounting error σe", "0.01");
  await lab.page.getByRole("button", { name: /^Sensor 2 at/ }).focus();
}

async function exploreOpen(lab: Lab): Promise<void> {
  await explore(lab);
  await lab.openGroups();
}

async function exploreNext(lab: Lab): Promise<void> {
  await explore(lab);
  await lab.openSheet();
  await lab.page.getByRole("combobox", { name: "Shows" }).selectOption("best next anchor");
  await expect(lab.page.getByRole("table", { name: "One more anchor" })).toBeVisible();
}

async function openDialog(lab: Lab, button: string): Promise<void> {
  await lab.page.getByRole("button", { name: button }).click();
  await expect(lab.page.getByRole("dialog")).toBeVisible();
}

async function enlarge(lab: Lab): Promise<void> {
  await lab.page.getByRole("button", { name: "Orientation error: enlarge" }).click();
  await expect(lab.page.locator(".plots figure")).toHaveCount(1);
}

async function averages(lab: Lab, study = "Monte-Carlo"): Promise<void> {
  await lab.page.getByRole("button", { name: study, exact: true }).click();
  await stopAtFirst(lab);
}

/** The first averages, and no more: pictures of a state do not change by themselves. */
async function stopAtFirst(lab: Lab): Promise<void> {
  const trials = lab.page.getByTestId("trials");
  await expect.poll(async () => Number(await trials.innerText()), { timeout: 60_000 }).toBeGreaterThan(0);
  const stop = lab.page.getByRole("button", { name: "Stop" });
  if (await stop.isEnabled()) await stop.click();
}

/** All of them are soon there. */
async function drawn(lab: Lab): Promise<void> {
  await lab.page.getByRole("button", { name: "Anchor draws" }).click();
  await expect(lab.page.getByTestId("trials")).toHaveText("500", { timeout: 60_000 });
}

async function innovations(lab: Lab): Promise<void> {
  await averages(lab);
  const chooser = lab.page.getByRole("group", { name: "Plots shown" });
  const button = chooser.getByRole("button", { name: "NIS" });
  if ((await button.getAttribute("aria-pressed")) === "false") await button.click();
}

async function indoor(lab: Lab, preset?: string): Promise<void> {
  await lab.page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Indoor" }).click();
  await expect(lab.page.getByRole("table", { name: "Errors of the filters" })).toBeVisible();
  if (preset) await lab.page.getByLabel("Preset").selectOption({ label: preset });
}

async function indoorAll(lab: Lab): Promise<void> {
  await indoor(lab, "An IMU that integrates inside");
  await lab.openSheet();
  const filters = await lab.openGroup("Filters");
  await filters.getByRole("button", { name: "All on" }).click();
  await expect(lab.page.locator("[data-filter]")).toHaveCount(9);
}

async function indoorOpen(lab: Lab): Promise<void> {
  await indoor(lab, "Gravity on the stairs");
  await lab.openGroups();
}

async function indoorChosen(lab: Lab): Promise<void> {
  await indoor(lab);
  await lab.choose(2);
}

async function indoorAverages(lab: Lab): Promise<void> {
  await indoor(lab);
  await averages(lab);
}

async function anchorless(lab: Lab, preset?: string): Promise<void> {
  const labs = lab.page.getByRole("navigation", { name: "Labs" });
  await labs.getByRole("button", { name: "Anchorless" }).click();
  await expect(lab.page.getByRole("table", { name: "Errors of the estimators" })).toBeVisible();
  if (preset) await lab.page.getByLabel("Preset").selectOption({ label: preset });
}

async function anchorlessTurned(lab: Lab): Promise<void> {
  await anchorless(lab);
  await lab.openSheet();
  await lab.type("Turn all nodes", "30");
  await lab.page.getByRole("checkbox", { name: "Mirror all nodes" }).check();
}

async function anchorlessChosen(lab: Lab): Promise<void> {
  await anchorless(lab);
  await lab.surface.focus();
  for (let press = 0; press < 12; press++) await lab.page.keyboard.press("n");
  await expect(lab.page.getByRole("group", { name: "Selected handle" })).toBeVisible();
}

async function anchorlessOpen(lab: Lab): Promise<void> {
  await anchorless(lab, "Ten stamps only");
  await lab.openGroups();
}

async function anchorlessAverages(lab: Lab, study: string): Promise<void> {
  await anchorless(lab);
  await averages(lab, study);
}
