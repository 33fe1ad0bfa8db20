/** A figure of a paper as the page reads it. */
import type { FigureReport as Written } from "./generated/FigureReport";
import type { IndoorScenario } from "./generated/IndoorScenario";
import type { KinematicsScenario } from "./generated/KinematicsScenario";
import type { Scenario } from "./scenario";

/** The report of the engine; JSON numbers are doubles here, and a number that is none is null in it. */
export interface FigureReport extends Omit<Written, "seed" | "scenarios"> {
  readonly seed: number;
  readonly scenarios: readonly {
    readonly name: string;
    readonly scenario: Scenario | IndoorScenario | KinematicsScenario;
  }[];
}

/** Which figure, over how many trials, from which seed. */
export interface FigureOrder {
  readonly name: string;
  readonly trials: number;
  readonly seed: number;
}

/** What the jobs joined so far say, as an object and as the texts of the command line's files. */
export interface FigurePicture {
  readonly report: FigureReport;
  readonly json: string;
}
