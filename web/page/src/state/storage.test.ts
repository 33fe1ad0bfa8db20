import { afterEach, expect, test, vi } from "vitest";
import { forget, keep, recall } from "./storage";

afterEach(() => vi.unstubAllGlobals());

function memory(): Storage {
  const values: Record<string, string> = {};
  return {
    getItem: (key: string) => values[key] ?? null,
    setItem: (key: string, value: string) => void (values[key] = value),
    removeItem: (key: string) => void delete values[key],
  } as Storage;
}

test("what is kept comes back until it is forgotten", () => {
  vi.stubGlobal("localStorage", memory());
  expect(recall("scene")).toBeNull();
  expect(keep("scene", "a")).toBe(true);
  expect(recall("scene")).toBe("a");
  forget("scene");
  expect(recall("scene")).toBeNull();
});

test("a browser that refuses to keep anything breaks nothing", () => {
  const refuse = () => {
    throw new DOMException("The quota has been exceeded.", "QuotaExceededError");
  };
  vi.stubGlobal("localStorage", { getItem: refuse, setItem: refuse, removeItem: refuse });
  expect(keep("scene", "a")).toBe(false);
  expect(recall("scene")).toBeNull();
  expect(() => forget("scene")).not.toThrow();
});

test("neither does one whose storage is switched off", () => {
  vi.stubGlobal("localStorage", undefined);
  expect(keep("scene", "a")).toBe(false);
  expect(recall("scene")).toBeNull();
});
