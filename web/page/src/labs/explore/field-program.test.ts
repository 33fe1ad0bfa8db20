import { beforeAll, expect, test } from "vitest";
import { fieldProgram, preset, presets } from "../../engine";
import { loadEngineForTests } from "../../engine/testing";
import type { Scenario } from "../../scenario";
import { programOf } from "./field-program";

beforeAll(loadEngineForTests);

test("a scenario has one program, 512 cells along its longer edge", () => {
  const scenario = preset("room");
  const program = programOf(scenario);
  expect(programOf(scenario)).toBe(program);
  expect(Math.max(program.width, program.height)).toBe(512);
  const moved = structuredClone(scenario);
  moved.anchors[0][0] += 0.5;
  expect(programOf(moved).parameters).not.toEqual(program.parameters);
});

test("nothing is worked out before it is read", () => {
  const program = programOf({ ...preset("room"), anchors: [] });
  expect(program.key).toContain("3");
  expect(() => program.parameters).toThrow("anchors");
});

test("programs of one key have the text that the engine gives, whatever else differs", () => {
  const texts = new Map<string, string>();
  for (const { name } of presets())
    for (const form of ["raw", "projected"] as const)
      for (const quantity of ["position", "orientation"] as const) {
        const base = preset(name);
        const scenario: Scenario = { ...base, field: { ...base.field, form, quantity } };
        const { key, text } = programOf(scenario);
        expect(text).toBe(fieldProgram(scenario));
        texts.set(key, text);
      }
  expect(new Set(texts.values()).size).toBe(texts.size);
});
