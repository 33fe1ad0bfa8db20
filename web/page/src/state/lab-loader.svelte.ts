import type { Lab } from "../lab";

/** Loads what a lab needs besides the page, once; what is asked for next comes instead of what is still on its way. */
export class LabLoader {
  /** The lab that is on its way. */
  loading: Lab | null = $state.raw(null);
  readonly #loaded = new WeakSet<Lab>();
  #request = 0;

  /** Whether the lab can compute now. */
  has(lab: Lab): boolean {
    return lab.load === undefined || this.#loaded.has(lab);
  }

  /** Calls `then` at once where the lab is there, else when it has come, or `failed` with the reason. */
  whenThere(lab: Lab, then: () => void, failed: (error: unknown) => void): void {
    const request = ++this.#request;
    this.loading = null;
    if (this.has(lab)) return then();
    this.loading = lab;
    const wanted = () => {
      if (request !== this.#request) return false;
      this.loading = null;
      return true;
    };
    lab.load!().then(
      () => {
        this.#loaded.add(lab);
        if (wanted()) then();
      },
      (error: unknown) => {
        if (wanted()) failed(error);
      },
    );
  }
}
