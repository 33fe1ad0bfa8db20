/**
 * The only door to the WebAssembly modules: what every lab needs in one, what a lab needs besides in one of its own, the
 * scene renderer in two builds. What leaves this folder are plain objects, typed arrays and errors whose message is a
 * sentence for the student.
 */
import { anchorlessModule } from "./anchorless";
import { exploreModule } from "./explore";
import { figuresModule } from "./figures";
import { indoorModule } from "./indoor";
import { localizeModule } from "./localize";
import { trackModule } from "./track";

export * from "./anchorless";
export * from "./explore";
export * from "./figures";
export * from "./indoor";
export * from "./localize";
export { type EngineModule, EngineTrap } from "./module";
export { EngineRestarted } from "./resident";
export * from "./scene";
export * from "./studies";
export * from "./track";

/** By the folder below `wasm/` that each is built into. */
export const modules = {
  track: trackModule,
  explore: exploreModule,
  localize: localizeModule,
  indoor: indoorModule,
  anchorless: anchorlessModule,
  figures: figuresModule,
};
