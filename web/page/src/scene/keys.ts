import * as actions from "../state/scene-actions";
import type { Session } from "../state/session.svelte";
import type { Hands } from "./hands.svelte";
import { type SceneAction, sceneAction } from "./keyboard";
import type { PointerControl } from "./pointer";
import type { SceneView } from "./scene-view.svelte";

/** What keys do while the scene has the focus. */
export class KeyControl {
  /** An arrow key is down: its moves become one edit when it comes up. */
  #nudging = false;

  constructor(
    readonly session: Session,
    readonly look: SceneView,
    readonly hands: Hands,
    readonly pointer: PointerControl,
  ) {}

  down = (event: KeyboardEvent): void => {
    const { session, look } = this;
    const anyChosen = session.selected.length > 0;
    const action = sceneAction(event, {
      camera: look.camera,
      viewport: look.viewport,
      planar: look.planar,
      anyChosen,
    });
    if (!action) return;
    event.preventDefault();
    this.#act(action, event.shiftKey);
  };

  up = (): void => {
    if (this.#nudging) this.session.commit();
    this.#nudging = false;
  };

  #act(action: SceneAction, shift: boolean): void {
    const { session, look, hands } = this;
    if (action.kind === "camera") return look.set(action.camera);
    if (action.kind === "choose" && action.index < session.room.anchors.length)
      return actions.select(session, [action.index]);
    if (action.kind === "next") return actions.selectNext(session, action.by);
    if (action.kind === "nudge") {
      this.#nudging ||= actions.nudge(session, action.direction, shift);
      return;
    }
    const plain: Partial<Record<SceneAction["kind"], () => void>> = {
      all: () => actions.selectAll(session),
      add: () => hands.addAt(),
      remove: () => actions.removeChosen(session),
      duplicate: () => actions.duplicate(session),
      destination: () => hands.setTool(session.selected.length > 0 ? "destination" : "move"),
      several: () => hands.setTool(hands.tool() === "several" ? "move" : "several"),
      fit: () => look.show("all"),
      body: () => look.show(look.subject === "body" ? "all" : "body"),
      centre: () => look.centre(hands.middle()),
      release: () => this.#release(),
    };
    plain[action.kind]?.();
  }

  /** Lets go of one thing at a time: the drag, the tool, what is chosen. */
  #release(): void {
    if (this.pointer.cancel()) return;
    if (this.hands.tool() !== "move") this.hands.setTool("move");
    else actions.select(this.session, []);
  }
}
