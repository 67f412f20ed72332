/** Time until code that could not be fetched is asked for again: at first, and at most, each time twice as long (ms). */
const FIRST_WAIT = 1000;
const LONGEST_WAIT = 60_000;

/** A part of the package in files of its own, fetched when it is first needed; shared by all renderers of a page. */
export class LateCode<Code> {
  /** Null until it is there. */
  code: Code | null = null;
  private loading: Promise<Code> | null = null;
  private wait = FIRST_WAIT;
  private waits = false;
  private told = false;

  /**
   * @param fetch called again after a failure
   * @param what the code is of
   * @param instead what is drawn without it
   */
  constructor(
    private readonly fetch: () => Promise<Code>,
    private readonly what: string,
    private readonly instead: string,
  ) {}

  /** Fetches it, at once also after a failure. @throws Error when it cannot be fetched */
  load(): Promise<Code> {
    if (this.code !== null) return Promise.resolve(this.code);
    this.loading ??= this.fetch().then(
      (code) => (this.code = code),
      (error: unknown) => {
        this.loading = null;
        throw error;
      },
    );
    return this.loading;
  }

  /** Has it fetched; to be called for each frame without it. After a failure, told once, it is asked for after a while. */
  ask(): void {
    if (this.loading === null && !this.waits) this.load().catch(this.fail);
  }

  private readonly fail = (error: unknown): void => {
    if (!this.told) {
      const message = `Farol: the code of ${this.what} cannot be fetched; until it can, ${this.instead}`;
      console.warn(`${message} (${String(error)}). Serve the files of @farol/renderer together.`);
    }
    this.told = this.waits = true;
    const timer = setTimeout(() => again(), this.wait);
    this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
    const again = (): void => {
      this.waits = false;
      clearTimeout(timer);
      globalThis.removeEventListener?.('online', again);
    };
    globalThis.addEventListener?.('online', again);
  };
}
