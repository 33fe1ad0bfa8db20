import type { Scenario } from "../scenario";

/** Trials that one worker runs at a time. */
export interface Block {
  readonly scenario: Scenario;
  readonly firstTrial: number;
  readonly trials: number;
}

export type Request =
  | { readonly kind: "load"; readonly module: WebAssembly.Module }
  | { readonly kind: "block"; readonly block: Block };

export type Answer =
  | { readonly kind: "sums"; readonly sums: Float64Array<ArrayBuffer> }
  /** The scenario itself is at fault: another worker would say the same. */
  | { readonly kind: "refused"; readonly sentence: string };
