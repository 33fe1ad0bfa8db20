/** One line of the export menu. */
export interface Export {
  /** What is saved and as what: "Scene as a picture (PNG)". */
  readonly label: string;
  run(): void | Promise<void>;
}

/** What can be saved from the page: each part adds its own and takes it out when it goes. */
export class Exports {
  list: readonly Export[] = $state.raw([]);

  /** Returns what takes it out again, as an effect wants it: `$effect(() => workspace.exports.add({…}))`. */
  add(entry: Export): () => void {
    this.list = [...this.list, entry];
    return () => (this.list = this.list.filter((other) => other !== entry));
  }
}

/** Hands the visitor a file. */
export function saveFile(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // The browser has taken hold of the contents by the next task.
  setTimeout(() => URL.revokeObjectURL(link.href));
}
