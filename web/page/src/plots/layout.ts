/** Narrower or lower than this a plot says too little, in units of the font size. */
const LEAST_WIDTH = 14.5;
const LEAST_HEIGHT = 9.5;
/** The shape of a plot that reads best, width to height. */
const GOOD_ASPECT = 1.9;

export interface Arrangement {
  readonly columns: number;
  /** How many plots there is room for. */
  readonly count: number;
}

/** Rows and columns for `wanted` plots in the room there is: as many as can be read, shaped as well as can be. */
export function arrange(wanted: number, width: number, height: number, fontSize: number): Arrangement {
  const mostColumns = Math.max(1, Math.floor(width / (LEAST_WIDTH * fontSize)));
  const mostRows = Math.max(1, Math.floor(height / (LEAST_HEIGHT * fontSize)));
  const count = Math.min(wanted, mostColumns * mostRows);
  const misfit = (columns: number) => {
    const aspect = width / columns / (height / Math.ceil(count / columns));
    return Math.abs(Math.log(aspect / GOOD_ASPECT));
  };
  const possible = Array.from({ length: mostColumns }, (_, i) => i + 1).filter(
    (columns) => columns <= count && Math.ceil(count / columns) <= mostRows,
  );
  const full = possible.filter((columns) => count % columns === 0);
  const fitting = full.length > 0 ? full : possible;
  const columns = fitting.reduce(
    (best, next) => (misfit(next) < misfit(best) ? next : best),
    fitting[0] ?? 1,
  );
  return { columns, count };
}
