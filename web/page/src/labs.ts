import type { Lab } from "./lab";

const modules = import.meta.glob<{ lab: Lab }>("./labs/*/index.ts", { eager: true });

/** Every lab there is, in the order of the header. */
export const LABS: readonly Lab[] = Object.values(modules)
  .map((module) => module.lab)
  .sort((a, b) => a.order - b.order);
