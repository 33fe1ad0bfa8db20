import { describe, expect, test } from "vitest";
import { History } from "./history";

describe("History", () => {
  test("undoes and redoes single edits in order", () => {
    const history = new History(0);
    history.edit(1);
    history.edit(2);
    expect(history.undo()).toBe(2);
    expect(history.present).toBe(1);
    expect(history.redo()).toBe(2);
    expect(history.present).toBe(2);
    expect(history.redo()).toBeUndefined();
  });

  test("a gesture of many previews is one entry", () => {
    const history = new History(0);
    for (let i = 1; i <= 50; i++) history.preview(i);
    history.commit();
    expect(history.present).toBe(50);
    history.undo();
    expect(history.present).toBe(0);
    expect(history.canUndo).toBe(false);
  });

  test("undo in the middle of a gesture takes the gesture back", () => {
    const history = new History(0);
    history.preview(7);
    expect(history.canUndo).toBe(true);
    history.undo();
    expect(history.present).toBe(0);
  });

  test("a cancelled gesture leaves no entry", () => {
    const history = new History(0);
    history.preview(7);
    history.cancel();
    expect(history.present).toBe(0);
    expect(history.canUndo).toBe(false);
  });

  test("a new edit forgets what was undone", () => {
    const history = new History(0);
    history.edit(1);
    history.undo();
    history.edit(2);
    expect(history.canRedo).toBe(false);
    expect(history.present).toBe(2);
  });

  test("what is discarded cannot be redone", () => {
    const history = new History(0);
    history.edit(1);
    history.edit(2);
    history.discard();
    expect([history.present, history.canRedo]).toEqual([1, false]);
    history.preview(7);
    history.discard();
    expect([history.present, history.inGesture]).toEqual([1, false]);
  });

  test("names what redo would bring back, and keeps more than two hundred entries", () => {
    const history = new History(0);
    for (let i = 1; i <= 300; i++) history.edit(i);
    for (let i = 0; i < 300; i++) history.undo();
    expect([history.present, history.next, history.canUndo]).toEqual([0, 1, false]);
  });

  test("keeps the last `depth` entries", () => {
    const history = new History(0, 3);
    for (let i = 1; i <= 10; i++) history.edit(i);
    while (history.canUndo) history.undo();
    expect(history.present).toBe(7);
  });
});
