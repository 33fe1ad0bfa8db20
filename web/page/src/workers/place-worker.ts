/** Searches better places for the anchors. */
import { exploreModule, improve } from "../engine/explore";
import type { Improvement } from "../generated/Improvement";
import type { Search } from "./messages";
import { serve } from "./serve";

serve<Search, Improvement>(exploreModule, ({ scenario, restart }) => improve(scenario, restart));
