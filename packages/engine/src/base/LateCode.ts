/** Code that most scenes do not need, fetched on first use; shared by all scenes of a page. */
export class LateCode<Code> {
  /** Fetches of late code that are under way, of all instances. */
  static readonly fetching = new Set<Promise<unknown>>();
  /** The fetched code; null until `load` is done. */
  code: Code | null = null;
  private loading: Promise<Code> | null = null;

  /**
   * @param fetch - called again after a failure
   * @param failure - message for the user when it cannot be fetched; default: the error of `fetch`
   */
  constructor(
    private readonly fetch: () => Promise<Code>,
    private readonly failure?: string,
  ) {}

  /** Fetches the code. @throws Error (as a rejection) when it cannot be fetched; try again */
  load(): Promise<Code> {
    return (this.loading ??= this.begin());
  }

  /** The code; null until it is there: then `again` is called. A failure is told on the console. */
  codeOr(again: () => void): Code | null {
    if (this.code === null) this.load().then(again, (error: Error) => console.error(`Farol: ${error.message}`));
    return this.code;
  }

  private begin(): Promise<Code> {
    const promise = this.fetch()
      .then(
        (code) => (this.code = code),
        (cause: unknown) => {
          this.loading = null;
          throw this.failure === undefined ? cause : new Error(this.failure, { cause });
        },
      )
      .finally(() => LateCode.fetching.delete(promise));
    LateCode.fetching.add(promise);
    return promise;
  }
}
