import { watchPixelRatio } from '@farol/engine';

/** Keeps a canvas as large as the element that it is in. */
export class CanvasPlace {
  /** CSS pixels, 1 at least. */
  width = 1;
  height = 1;

  private readonly resizer = new ResizeObserver(() => this.measure());
  private readonly unwatch = watchPixelRatio(() => this.measure());

  /** @param resized - called when the element may have another size, or the screen another pixel ratio; `width` and `height` are set */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly resized: () => void,
  ) {}

  /** Puts the canvas into an element, whose size it follows. */
  attach(parent: HTMLElement): void {
    parent.append(this.canvas);
    this.resizer.observe(parent);
    this.measure();
  }

  /** Takes the canvas out of where it is. */
  detach(): void {
    this.resizer.disconnect();
    this.canvas.remove();
  }

  dispose(): void {
    this.unwatch();
    this.resizer.disconnect();
  }

  private measure(): void {
    const parent = this.canvas.parentElement;
    if (!parent) return;
    this.width = Math.max(1, parent.clientWidth);
    this.height = Math.max(1, parent.clientHeight);
    this.resized();
  }
}
