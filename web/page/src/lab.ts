import type { Component } from "svelte";
import type { Family, SceneDocument } from "./family";
import type { Preset } from "./generated/Preset";
import type { PlotSpec } from "./plots/spec";
import type { PoseTrack } from "./run";
import type { Shape } from "./scene/draw-list";
import type { FieldPicture } from "./scene/field";
import type { Label, Layer, SceneInput, UncertaintyShown } from "./scene/input";
import type { Drawing, Handle } from "./state/handles";
import type { Averages, StudyPicture, StudySubject } from "./state/study.svelte";
import type { Block, Sums } from "./workers/messages";
import type { PoolWorker } from "./workers/pool";

/** What every lab's run has: all that the frame itself reads of it. */
export interface LabRun {
  readonly dimension: number;
  readonly steps: number;
  /** Seconds, one a step. */
  readonly times: Float64Array;
  /** The anchors used, M rows: presets that redraw anchors differ from the scenario here. */
  readonly anchors: number[][];
  readonly truth: PoseTrack;
}

/** Steps at which something happened, shown on the timeline. */
export interface TimelineMarks {
  /** What happened, as a plural and of one: "projections of ET-KF", "ET-KF projected". */
  readonly label: string;
  readonly one: string;
  /** The design token of the colour, and the mark that doubles it. */
  readonly token: string;
  readonly mark: Shape;
  readonly steps: readonly number[];
}

/** Averages over many trials of a lab's scenarios, and their plots. */
export interface LabStudy<
  R extends LabRun = LabRun,
  A extends Averages = Averages,
  S extends SceneDocument = SceneDocument,
> {
  /** Whether the plots are always of the averages: then there is no run of its own to go back to. */
  readonly always: boolean;
  subject(scenario: S, run: R): StudySubject<A, S>;
  startWorker(): PoolWorker<Block, Sums>;
  /** The scenario at hand and its run may be newer than the picture. */
  plots(picture: StudyPicture<A, S>, scenario: S, run: R): PlotSpec[];
  /** What the plots show, in a sentence or two; without it they speak for themselves. */
  told?(picture: StudyPicture<A, S>, scenario: S): string;
}

/** A study whose plots are a page of their own, beside the run and the averages over time. */
export interface StudyPage<
  R extends LabRun = LabRun,
  A extends Averages = Averages,
  S extends SceneDocument = SceneDocument,
> extends LabStudy<R, A, S> {
  readonly title: string;
}

/**
 * A lab plugs into the frame: what it computes from a scenario, and how that is drawn, plotted, said and changed.
 * Each is a folder `labs/NAME/index.ts` that exports its `lab`; the frame finds it there.
 */
export interface Lab<R extends LabRun = LabRun, S extends SceneDocument = SceneDocument> {
  /** Stands in links as `view.lab`. */
  readonly name: string;
  readonly title: string;
  /** Labs stand in the header in this order; the first opens where a scenario names none. */
  readonly order: number;
  /** The kind of its documents. */
  readonly family: Family<S>;
  /** Brings what the lab needs besides the page itself; a lab without it is there at once. It can be asked for again. */
  load?(): Promise<void>;
  presets(): readonly Preset[];
  preset(name: string): S;
  /** What opens without a link. */
  readonly firstPreset: string;
  /** Throws an `Error` with a sentence. */
  compute(scenario: S): R;
  /** Ends what it does besides computing: another lab is opened. */
  leave?(): void;
  /** What the scene is a picture of, as its name for those who do not see it. */
  readonly shows: string;
  readonly layers: readonly Layer<R, S>[];
  /** What is chosen and moved beside the anchors and the start of the body; a lab with handles draws their layer. */
  handles?(scenario: S): readonly Handle<S>[];
  /** What one can draw over the floor by hand. */
  readonly drawings?: readonly Drawing<S>[];
  /** A grid of numbers under the layers, the same object as long as it shows the same; a lab without it draws none. */
  field?(input: SceneInput<R, S>): FieldPicture | null;
  /** What is found after the run and drawn with it: a change of any of it draws the scene anew. */
  found?(): readonly unknown[];
  /** What the scene's uncertainty of each kind looks like, where it is not of ellipsoids and fans; others are not drawn. */
  readonly uncertainty?: Readonly<Partial<Record<keyof UncertaintyShown, string>>>;
  labels(input: SceneInput<R, S>): Label[];
  /** What one must know to read the scene as it is now, shown beside it; empty where it is plain. */
  note(input: SceneInput<R, S>): string;
  /** What the scene shows, a sentence a thing, for those who do not see it; anchors and the true body are told already. */
  told(input: SceneInput<R, S>): readonly string[];
  /** A lab without it has no pane of plots. */
  plots?(scenario: S, run: R): PlotSpec[];
  /** Averages over many trials; a lab without it has no such view. */
  readonly study?: LabStudy<R, Averages, S>;
  readonly studyPages?: readonly StudyPage<R, Averages, S>[];
  marks(run: R): readonly TimelineMarks[];
  /** What the run shows at a step, in a few sentences. */
  describe(run: R, step: number): string;
  /** What stands beside the plots, in their pane; a lab without it leaves them all the room. */
  readonly Bench?: Component;
  readonly Controls: Component;
  readonly Readout: Component;
}

/**
 * The lab a document is for: the one its view names; where it names none the first that documents like it are for, or
 * the first of all; undefined where there is no such lab.
 */
export function labOf(document: object, labs: readonly Lab[]): Lab | undefined {
  const wanted = (document as Partial<SceneDocument>).view?.["lab"];
  if (wanted === undefined) return labs.find((lab) => lab.family.claims(document)) ?? labs[0];
  return labs.find((lab) => lab.name === wanted);
}

/** The scenario marked as one for the lab, so that its link opens there; the first lab of a family needs no mark. */
export function forLab<S extends SceneDocument>(scenario: S, lab: Lab, labs: readonly Lab[]): S {
  if (labOf(scenario, labs) === lab) return scenario;
  return { ...scenario, view: { ...scenario.view, lab: lab.name } };
}
