/** Something worth saying about a run. */
export interface Finding {
  readonly text: string;
  /** How much it matters; a few of the weightiest are said. */
  readonly weight: number;
}

/** More than this nobody reads while the scene moves. */
const MOST_SENTENCES = 3;
const MOST_CHARACTERS = 230;

/** The weightiest findings in one to three sentences, in the order in which they are given. */
export function weightiest(all: readonly Finding[]): string {
  const chosen = new Set<Finding>();
  let length = 0;
  for (const finding of all.toSorted((one, other) => other.weight - one.weight)) {
    length += finding.text.length + 1;
    if (chosen.size > 0 && (chosen.size === MOST_SENTENCES || length > MOST_CHARACTERS)) break;
    chosen.add(finding);
  }
  return all
    .filter((finding) => chosen.has(finding))
    .map(({ text }) => text)
    .join(" ");
}
