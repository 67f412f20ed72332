import { Lazy } from '../frame/Lazy';

/** Late code that the last frame of a renderer needed and was not loaded. */
export class LastFrame {
  /** Parts of late code that the last frame needed and were not loaded. */
  readonly lacking = new Set<Lazy<object>>();
  /** False before the first frame, and from the loss of the context to the next frame. */
  isDrawn = false;
  /** Callbacks, each called once after the next frame or when the renderer is disposed. */
  readonly waiting: (() => void)[] = [];

  /** @param redraw - called when a part that the last frame lacked is loaded */
  constructor(readonly redraw: () => void) {}

  /** Names of the lacking parts that are still not loaded. */
  get pending(): string[] {
    return [...this.lacking].filter((part) => !part.isThere).map((part) => part.name);
  }

  /** Begins a frame. @returns the set in which an enclosing frame of another renderer notes lacking parts */
  begin(): typeof Lazy.lacking {
    const outer = Lazy.lacking;
    Lazy.lacking = this.lacking;
    this.lacking.clear();
    return outer;
  }

  /** Ends the frame, and calls `waiting`'s callbacks. */
  end(): void {
    this.isDrawn = true;
    this.lacking.forEach(this.await);
    this.tell();
  }

  /** Calls the callbacks in `waiting`, and empties it. */
  tell(): void {
    while (this.waiting.length > 0) this.waiting.pop()!();
  }

  private readonly await = (part: Lazy<object>): void => void part.waiting.add(this.redraw);
}
