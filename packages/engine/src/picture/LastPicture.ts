import type { Scene } from '../core/Scene';

/** State of a PictureRenderer's last frame, by which it is decided whether another frame is needed. */
export class LastPicture {
  /** Scene of the last picture; null before the first. */
  scene: Scene | null = null;
  /** Whether a frame was asked for and has not begun yet. */
  isStale = false;
  isDisposed = false;
  /** Called once each, after the next frame or when the renderer is disposed. */
  readonly waiting: (() => void)[] = [];

  /** @param askHost - has the host draw a frame */
  constructor(private readonly askHost: () => void) {}

  /** Asks for another frame. */
  readonly redraw = (): void => {
    this.isStale = true;
    this.askHost();
  };

  begin(scene: Scene): void {
    this.scene = scene;
    this.isStale = false;
  }

  end(): void {
    while (this.waiting.length > 0) this.waiting.pop()!();
  }

  dispose(): void {
    this.isDisposed = true;
    this.end();
  }
}
