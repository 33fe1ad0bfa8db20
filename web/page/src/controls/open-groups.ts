/** Which groups of controls one opened or closed, kept between visits. */
const KEY = "groups";

export function isOpen(title: string, initially: boolean): boolean {
  return remembered()[title] ?? initially;
}

export function rememberOpen(title: string, open: boolean): void {
  localStorage.setItem(KEY, JSON.stringify({ ...remembered(), [title]: open }));
}

/** What is stored, or nothing where it is not what this page wrote. */
function remembered(): Record<string, boolean> {
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return Object.fromEntries(Object.entries(stored ?? {}).filter(([, open]) => typeof open === "boolean"));
  } catch {
    return {};
  }
}
