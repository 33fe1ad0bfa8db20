/** Searches better places for the anchors. */
import { improve } from "../engine";
import type { Improvement } from "../generated/Improvement";
import type { Search } from "./messages";
import { serve } from "./serve";

serve<Search, Improvement>(({ scenario, restart }) => improve(scenario, restart));
