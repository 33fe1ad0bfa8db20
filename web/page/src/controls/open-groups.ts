import { keep, recall } from "../state/storage";

/** Which groups of controls one opened or closed, kept between visits. */
const KEY = "groups";

export function isOpen(title: string, initially: boolean): boolean {
  return remembered()[title] ?? initially;
}

export function rememberOpen(title: string, open: boolean): void {
  keep(KEY, JSON.stringify({ ...remembered(), [title]: open }));
}

/** What is stored, or nothing where it is not what this page wrote. */
function remembered(): Record<string, boolean> {
  try {
    const stored: unknown = JSON.parse(recall(KEY) ?? "{}");
    return Object.fromEntries(Object.entries(stored ?? {}).filter(([, open]) => typeof open === "boolean"));
  } catch {
    return {};
  }
}
