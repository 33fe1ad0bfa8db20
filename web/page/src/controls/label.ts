/** Labels are written as plain text with `_` before a subscript: "Turn rate σ_ω". */

export interface LabelPart {
  readonly text: string;
  readonly subscript: boolean;
}

/** The label cut into what stands on the line and what stands below it. */
export function labelParts(label: string): LabelPart[] {
  return label
    .split(/_([\p{L}\p{N}]+)/u)
    .map((text, index) => ({ text, subscript: index % 2 === 1 }))
    .filter(({ text }) => text !== "");
}

/** The label where nothing can be set lower: in announcements and accessible names. */
export function plainLabel(label: string): string {
  return labelParts(label)
    .map(({ text }) => text)
    .join("");
}
