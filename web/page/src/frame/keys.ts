import type { Workspace } from "../state/workspace.svelte";

/** Keys by which a browser scrolls: they are left to what has the focus to be scrolled, and where there is no timeline. */
const SCROLLING = [" ", "Home", "End"];

/** Whether the element or one around it, short of the page, has more than it shows. */
function scrolls(element: Element): boolean {
  for (let each: Element | null = element; each && each !== document.body; each = each.parentElement)
    if (each.scrollHeight > each.clientHeight && /auto|scroll/.test(getComputedStyle(each).overflowY))
      return true;
  return false;
}

/** Keys that work everywhere, except where the focused control uses them itself. */
export function globalKeys(event: KeyboardEvent, workspace: Workspace): void {
  const target = event.target instanceof Element ? event.target : document.body;
  if (event.defaultPrevented || target.closest("dialog, [popover]")) return;
  if (event.ctrlKey || event.metaKey) return historyKeys(event, target, workspace);
  if (event.altKey || target.closest("input, select, textarea")) return;
  if (event.key === " " && target.closest("button, summary")) return;
  if (SCROLLING.includes(event.key) && (workspace.timeline.count === 1 || scrolls(target))) return;
  const { timeline, session } = workspace;
  const marks = () => (session.run ? session.lab.marks(session.run).flatMap((entry) => entry.steps) : []);
  const actions: Record<string, () => void> = {
    " ": () => timeline.toggle(),
    ",": () => timeline.stepBy(-1),
    ".": () => timeline.stepBy(1),
    Home: () => timeline.reset(),
    End: () => timeline.stepBy(timeline.count),
    "[": () => timeline.toMark(marks(), -1),
    "]": () => timeline.toMark(marks(), 1),
    l: () => (timeline.loop = !timeline.loop),
    r: () => (workspace.figuresOpen = true),
    "?": () => (workspace.helpOpen = true),
  };
  if (!(event.key in actions)) return;
  event.preventDefault();
  actions[event.key]();
}

/** A field with unfinished typing in it undoes that. */
function historyKeys(event: KeyboardEvent, target: Element, { session }: Workspace): void {
  if (target.closest("[data-typed]")) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) session.redo();
  else session.undo();
}
