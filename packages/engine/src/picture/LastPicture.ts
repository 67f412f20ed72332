import type { Scene } from '../core/Scene';

/** State of a PictureRenderer's last frame, from which the need for another frame is decided. */
export class LastPicture {
  /** Scene of the last picture; null before the first. */
  scene: Scene | null = null;
  /** Whether a frame was requested and has not begun yet. */
  isStale = false;
  isDisposed = false;
  /** Callbacks for the next frame or the disposal, whichever comes first; each is called once. */
  readonly waiting: (() => void)[] = [];

  /** @param askHost - requests a frame from the host */
  constructor(private readonly askHost: () => void) {}

  /** Requests another frame. */
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
