import type { Lab, LabRun } from "../lab";
import type { SceneDocument } from "../family";
import { START } from "../state/handles";
import { handlesOf } from "../state/things";
import { lowerFirst, withArticle } from "../words";

/** A key or gesture, and what it does. */
export type Line = readonly [what: string, does: string];

/** What keys and gestures do depends on what there is: lines about anything else would only be looked for in vain. */
export interface HelpScope {
  /** What an anchor and what moves among them are called. */
  readonly anchor: string;
  readonly body: string;
  readonly hasStart: boolean;
  /** The name of a handle there is beside the start of the body; null where there is none. */
  readonly handle: string | null;
  readonly draws: boolean;
  /** Whether there is a body designer. */
  readonly designs: boolean;
  readonly timed: boolean;
  /** Whether something happens at some of the steps. */
  readonly marked: boolean;
  /** What a press on a plot does. */
  readonly onPlot: "goes to that time" | "brings the scenario there" | null;
}

export function scopeOf<S extends SceneDocument>(
  lab: Lab<LabRun, S>,
  scenario: S,
  run: LabRun | null,
): HelpScope {
  const handles = handlesOf({ lab, scenario });
  const plots = run ? (lab.plots?.(scenario, run) ?? []) : [];
  const edits = plots.some(({ x }) => x.edit);
  const times = plots.some(({ x }) => x.timed);
  return {
    anchor: lab.family.anchor,
    body: lab.family.body,
    hasStart: handles.some(({ id }) => id === START),
    handle: handles.find(({ id }) => id !== START)?.name ?? null,
    draws: (lab.drawings ?? []).length > 0,
    designs: lab.Bench !== undefined,
    timed: run !== null && run.steps > 1,
    marked: run !== null && lab.marks(run).some(({ steps }) => steps.length > 0),
    onPlot: edits ? "brings the scenario there" : times ? "goes to that time" : null,
  };
}

const OR = new Intl.ListFormat("en-GB", { type: "disjunction" });
const only = (there: boolean, ...lines: Line[]): Line[] => (there ? lines : []);

export function keysFor(scope: HelpScope): Line[] {
  const { anchor, body, hasStart, handle, designs, timed, marked } = scope;
  const chosen = OR.format([
    withArticle(anchor),
    ...(hasStart ? [`the start of the ${body}`] : []),
    ...(handle === null ? [] : ["a handle"]),
  ]);
  return [
    ...only(
      timed,
      ["Space", "play or pause"],
      [", and .", "one step back, one step on"],
      ["Home, End", "first step, last step"],
    ),
    ...only(timed && marked, ["[ and ]", "the event before, the event after"]),
    ...only(timed, ["L", "play again and again, or once"]),
    ["Ctrl Z, Ctrl Y", "undo, redo"],
    ["N, P or 1–9", `choose ${chosen} (in the scene)`],
    ["Ctrl A", `choose all ${anchor}s (in the scene)`],
    ["Arrows", "move what is chosen; turn the scene where nothing is, with Shift move it"],
    ["Page Up, Page Down", "lift and lower what is chosen"],
    ["Shift with these", "fine steps"],
    ["A, D, Delete", `add ${withArticle(anchor)} where the pointer is, duplicate, remove what is chosen`],
    ["G, M", "send what is chosen to the next press; choose several by pressing them"],
    ...only(designs, [
      "Tab, arrows, Delete, A",
      "choose, move, remove and add sensors (in the body designer)",
    ]),
    ["+ and −", "nearer, farther"],
    ["F, B, C", `show everything, go along with the ${body}, bring what is chosen to the middle`],
    ["Escape", `let go of the ${anchor}; close what is open`],
    ["Arrows, Home, End, Enter", "move, close or open the bar between two parts that has the focus"],
    ["R", "the papers’ figures"],
    ["?", "this help"],
  ];
}

export function gesturesFor(scope: HelpScope): Line[] {
  const { anchor, body, handle, draws, designs, onPlot } = scope;
  return [
    [
      `Drag ${withArticle(anchor)}`,
      "moves what is chosen; with Shift, or by the triangle above it, up and down",
    ],
    ...only(handle !== null, [
      "Drag a handle",
      `moves what it is of: ${lowerFirst(handle ?? "")} and the like`,
    ]),
    ...only(draws, ["Draw…", "then drag over the floor, or press where it begins and where it ends"]),
    ["Ctrl with a drag", "to the lines of the grid; Ctrl with a press chooses one more"],
    ["Drag elsewhere", "turns the scene; with Shift or the right button, moves it; with Ctrl chooses"],
    [
      "Double press",
      `adds ${withArticle(anchor)} on the floor; brings ${withArticle(anchor)} or the ${body} to the middle`,
    ],
    ["Wheel, two fingers", "nearer, farther; two fingers also move and turn"],
    ...only(designs, [
      "Drag a sensor",
      "moves it on the body (in the body designer); beside the sensors turns the body",
    ]),
    ...only(onPlot !== null, ["Press on a plot", onPlot ?? ""]),
    ["Drag a bar", "makes the part behind it larger or smaller; a double click resets it"],
    ["Drop a file", "opens the scenario in it"],
  ];
}
