/** A part of the viewport whose code is fetched when it is first needed. */
export class LatePart<Part extends { dispose(): void }> {
  /** The part; null until its code was fetched. */
  part: Part | null = null;

  private isAsked = false;
  private isDisposed = false;

  /**
   * @param isNeeded - called by `get` until fetching begins: whether the part is needed
   * @param load - fetches the code; resolves to a function that creates the part
   * @param failed - called when the code cannot be fetched; this is not tried again
   */
  constructor(
    private readonly isNeeded: () => boolean,
    private readonly load: () => Promise<() => Part>,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** Returns the part, once it is needed and its code is fetched; null until then. */
  get(): Part | null {
    if (!this.isAsked && this.isNeeded()) {
      this.isAsked = true;
      this.load().then((make) => {
        if (!this.isDisposed) this.part = make();
      }, this.failed);
    }
    return this.part;
  }

  dispose(): void {
    this.isDisposed = true;
    this.part?.dispose();
  }
}
