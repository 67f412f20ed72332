/** A part of the viewport whose code is fetched when it is first needed. */
export class LatePart<Part extends { dispose(): void }> {
  /** The part; null until its code was fetched. */
  part: Part | null = null;

  private isAsked = false;
  private isDisposed = false;

  /**
   * @param isNeeded - asked each time until it is fetched
   * @param load - fetches the code; what it resolves to makes the part
   * @param failed - called when the code cannot be fetched; it is not asked for again
   */
  constructor(
    private readonly isNeeded: () => boolean,
    private readonly load: () => Promise<() => Part>,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** The part, once it was needed and its code is there. */
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
