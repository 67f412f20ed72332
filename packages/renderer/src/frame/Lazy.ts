/** First and greatest wait before failed code is fetched again (ms); each wait is twice the one before. */
const FIRST_WAIT = 1000;
const LONGEST_WAIT = 60_000;

/** A part of the package in separate files, fetched when first needed; shared by all renderers of a page. */
export class Lazy<Code extends object, Name extends string = string> {
  /** Parts that the current frame needs and that are not loaded; null while no frame is drawn. */
  static lacking: Set<Lazy<object>> | null = null;
  /** Callbacks, each called once when the code is loaded. */
  readonly waiting = new Set<() => void>();
  private code: Code | null = null;
  /** Fetch under way; null before the first and after a failure. */
  private loading: Promise<Code> | null = null;
  private wait = FIRST_WAIT;
  /**
   * Time from which on `ask` may fetch again, by `performance.now` (ms); 0 before the first failure. Later failures are not
   * reported.
   */
  private next = 0;

  /**
   * @param name - name of the part in `FarolInfo.pending` and messages
   * @param fetch - fetches the code; called again after a failure
   * @param instead - consequence of the missing code, for the warning
   */
  constructor(
    readonly name: Name,
    private readonly fetch: () => Promise<Code>,
    private readonly instead: string,
  ) {}

  /** Whether the code is loaded. */
  get isThere(): boolean {
    return this.code !== null;
  }

  /**
   * Result of `by` applied to the code; null until the code is loaded. Call in each frame that needs the code: the first call
   * fetches. A failure is reported once; the fetch is tried again after a while, or when the page is online again.
   */
  use<Made>(by: (code: Code) => Made): Made | null {
    return this.ask() ? by(this.code!) : null;
  }

  /**
   * Starts to fetch the code, unless a fetch is under way.
   * @param changesPicture - whether the frame's picture lacks the code. Default true
   * @returns whether the code is loaded
   */
  ask(changesPicture = true): boolean {
    if (this.isThere) return true;
    if (changesPicture) Lazy.lacking?.add(this);
    if (this.loading === null && performance.now() >= this.next) this.load().catch(this.fail);
    return false;
  }

  /** The fetched code. @throws Error while it is not loaded */
  get required(): Code {
    if (this.code === null)
      throw new Error(`Farol: the code of ${this.name} is not loaded; await FarolRenderer.preload() first.`);
    return this.code;
  }

  /** Fetches the code, after a failure without waiting. @throws Error when it cannot be fetched */
  load(): Promise<Code> {
    return (this.loading ??= this.fetch().then(
      (code) => {
        this.code = code;
        for (const go of this.waiting) go();
        this.waiting.clear();
        return code;
      },
      (cause: unknown) => {
        this.loading = null;
        throw new Error(
          `Farol: the code of ${this.name} cannot be fetched; until it can, ${this.instead} (${String(cause)}). Serve the files of @farol/renderer together.`,
        );
      },
    ));
  }

  private readonly fail = (error: Error): void => {
    if (this.next === 0) console.warn(error.message);
    this.next = performance.now() + this.wait;
    this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
    globalThis.addEventListener?.('online', this.retry);
  };

  private readonly retry = (): void => {
    this.next = 1; // a time in the past, so that the next use fetches again
  };
}
