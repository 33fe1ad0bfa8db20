/** A curve between its points, over the logarithm of what lies along it; beyond its ends it stays as it is there. */
export class Interpolation {
  constructor(
    /** Positive, increasing. */
    private readonly along: Float64Array,
    private readonly values: Float64Array,
  ) {}

  at(place: number): number {
    const { along, values } = this;
    const above = along.findIndex((each) => each >= place);
    if (above < 0) return values[values.length - 1];
    if (above === 0) return values[0];
    const share = Math.log(place / along[above - 1]) / Math.log(along[above] / along[above - 1]);
    return values[above - 1] + share * (values[above] - values[above - 1]);
  }

  /** The least place at which a falling curve has come down to `value`. */
  where(value: number): number {
    const { along, values } = this;
    const below = values.findIndex((each) => each <= value);
    if (below < 0) return along[along.length - 1];
    if (below === 0) return along[0];
    const share = (values[below - 1] - value) / (values[below - 1] - values[below]);
    return along[below - 1] * (along[below] / along[below - 1]) ** share;
  }
}
