import { Lazy } from '../frame/Lazy';

/** Whether the last frame of a renderer had all code that it asked for. */
export class LastFrame {
  /** Parts of the code that it asked for and lacked. */
  readonly lacking = new Set<Lazy<object>>();
  /** False before the first frame, and from the loss of the context to the next frame. */
  isDrawn = false;
  /** Called once each, after the next frame or when the renderer is disposed. */
  readonly waiting: (() => void)[] = [];

  /** @param redraw - called when a part has come that the last frame lacked */
  constructor(readonly redraw: () => void) {}

  /** Names of the parts that have not come since. */
  get pending(): string[] {
    return [...this.lacking].filter((part) => !part.isThere).map((part) => part.name);
  }

  /** Begins a frame. @returns where the frame that it lies within, of another renderer, notes what it lacks */
  begin(): typeof Lazy.lacking {
    const outer = Lazy.lacking;
    Lazy.lacking = this.lacking;
    this.lacking.clear();
    return outer;
  }

  /** The frame is drawn. */
  end(): void {
    this.isDrawn = true;
    this.lacking.forEach(this.await);
    this.tell();
  }

  /** Calls those who wait for a frame. */
  tell(): void {
    while (this.waiting.length > 0) this.waiting.pop()!();
  }

  private readonly await = (part: Lazy<object>): void => void part.waiting.add(this.redraw);
}
