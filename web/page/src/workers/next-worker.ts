/** Finds the best place for one more anchor. */
import { bestNext, exploreModule } from "../engine/explore";
import type { BestNext, Scene } from "./messages";
import { serve } from "./serve";

serve<Scene, BestNext>(exploreModule, ({ scenario }) => ({ place: bestNext(scenario) }));
