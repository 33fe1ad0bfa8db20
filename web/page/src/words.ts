/** Small helpers for sentences. */

const NUMBERS = "no one two three four five six seven eight nine ten eleven twelve".split(" ");

/** Small numbers as words, others as digits. */
export function countOf(count: number): string {
  return NUMBERS[count] ?? String(count);
}

/** "a node", "an anchor". */
export function withArticle(noun: string): string {
  return `${/^[aeiou]/i.test(noun) ? "an" : "a"} ${noun}`;
}

/** "KF, UC-KF and ESKF". */
export function joined(estimators: readonly { label: string }[]): string {
  return new Intl.ListFormat("en-GB").format(estimators.map(({ label }) => label));
}

/** As a sentence goes on. */
export function lowerFirst(text: string): string {
  return text.charAt(0).toLowerCase() + text.slice(1);
}

/** With a capital letter, as sentences begin; symbols such as x stay as they are. */
export function startOf(text: string): string {
  return /^\w\b/.test(text) ? text : text.charAt(0).toUpperCase() + text.slice(1);
}

/** What the engine says, as a sentence on the page: with a full stop, and formulas as they are written by hand. */
export function asSentence(text: string): string {
  const written = text.replaceAll("||s||^2", "‖s‖²");
  return /[.!?]$/.test(written) ? written : `${written}.`;
}
