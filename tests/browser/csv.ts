/** A saved table: what its comment lines say, and its rows by the names of the columns. */
export interface Table {
  readonly comments: string;
  readonly names: string[];
  readonly rows: Record<string, string>[];
}

export function readTable(text: string): Table {
  const lines = text.split(/\r?\n/).filter((line) => line !== "");
  const [names, ...rows] = lines.filter((line) => !line.startsWith("#")).map(cells);
  return {
    comments: lines.filter((line) => line.startsWith("#")).join("\n"),
    names,
    rows: rows.map((row) => Object.fromEntries(names.map((name, column) => [name, row[column]]))),
  };
}

/** Cells are plain, or in quotes where they hold a comma. */
function cells(line: string): string[] {
  return [...line.matchAll(/(?:^|,)(?:"([^"]*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted ?? plain);
}
