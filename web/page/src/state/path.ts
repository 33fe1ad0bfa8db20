/** Values of a scenario by path, written as the engine's problems write them: `motion.velocity[0]`. */

type Key = string | number;

function keysOf(path: string): Key[] {
  return path
    .replaceAll(/\[(\d+)\]/g, ".$1")
    .split(".")
    .map((key) => (/^\d+$/.test(key) ? Number(key) : key));
}

/** What stands at the path; undefined where the scenario has no such place. */
export function valueAt(scenario: object, path: string): unknown {
  return keysOf(path).reduce<unknown>((part, key) => (part as Record<Key, unknown> | null)?.[key], scenario);
}

/** The scenario with another value at the path; all else is shared with the old one. */
export function withValue<S extends object>(scenario: S, path: string, value: unknown): S {
  return replaced(scenario, keysOf(path), value) as S;
}

function replaced(part: unknown, [key, ...rest]: Key[], value: unknown): unknown {
  if (key === undefined) return value;
  const copy = Array.isArray(part) ? [...part] : { ...(part as Record<Key, unknown>) };
  const slots = copy as Record<Key, unknown>;
  slots[key] = replaced(slots[key], rest, value);
  return copy;
}

/** Whether any of the paths holds another value in the one than in the other. */
export function differsAt(one: object, other: object, paths: readonly string[]): boolean {
  return paths.some((path) => !same(valueAt(one, path), valueAt(other, path)));
}

function same(one: unknown, other: unknown): boolean {
  return one === other || JSON.stringify(one) === JSON.stringify(other);
}
