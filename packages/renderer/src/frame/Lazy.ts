/** Time after which code that could not be fetched is asked for again: at first, then twice as long each time, at most (ms). */
const FIRST_WAIT = 1000;
const LONGEST_WAIT = 60_000;

/** `failed`: asked for again only when the wait is over, or the page online again. */
type State<Code> =
  | { readonly is: 'absent' }
  | { readonly is: 'loading'; readonly promise: Promise<Code> }
  | { readonly is: 'failed' }
  | { readonly is: 'there'; readonly code: Code };

const ABSENT = { is: 'absent' } as const;

/** A part of the package in files of its own, fetched when first needed; shared by all renderers of a page. */
export class Lazy<Code> {
  private state: State<Code> = ABSENT;
  private wait = FIRST_WAIT;
  private told = false;

  /**
   * @param fetch called again after a failure
   * @param what the code is of, for the warning
   * @param instead what happens without it, for the warning
   */
  constructor(
    private readonly fetch: () => Promise<Code>,
    private readonly what: string,
    private readonly instead: string,
  ) {}

  /** Whether the code is there. */
  get isThere(): boolean {
    return this.state.is === 'there';
  }

  /**
   * What `by` makes of the code; null while it is not there, and then it is fetched. To be called in each frame that needs
   * it: after a failure, told once, it is asked for again after a while.
   */
  use<Made>(by: (code: Code) => Made): Made | null {
    if (this.state.is === 'there') return by(this.state.code);
    this.ask();
    return null;
  }

  /** Has the code fetched, unless that is under way. @returns whether it is there */
  ask(): boolean {
    if (this.state.is === 'absent') this.load().catch(this.fail);
    return this.isThere;
  }

  /** The code. @throws Error while it is not there */
  get required(): Code {
    if (this.state.is === 'there') return this.state.code;
    throw new Error(`Farol: the code of ${this.what} is not there; await FarolRenderer.preload() first.`);
  }

  /** Fetches the code, at once also after a failure. @throws Error when it cannot be fetched */
  load(): Promise<Code> {
    const { state } = this;
    if (state.is === 'there') return Promise.resolve(state.code);
    if (state.is === 'loading') return state.promise;
    const promise = this.fetch().then(
      (code) => {
        this.state = { is: 'there', code };
        return code;
      },
      (error: unknown) => {
        this.state = ABSENT;
        throw error;
      },
    );
    this.state = { is: 'loading', promise };
    return promise;
  }

  private readonly fail = (error: unknown): void => {
    if (!this.told) {
      const message = `Farol: the code of ${this.what} cannot be fetched; until it can, ${this.instead}`;
      console.warn(`${message} (${String(error)}). Serve the files of @farol/renderer together.`);
    }
    this.told = true;
    const failed = { is: 'failed' } as const;
    this.state = failed;
    const timer = setTimeout(() => again(), this.wait);
    this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
    const again = (): void => {
      if (this.state === failed) this.state = ABSENT;
      clearTimeout(timer);
      globalThis.removeEventListener?.('online', again);
    };
    globalThis.addEventListener?.('online', again);
  };
}
