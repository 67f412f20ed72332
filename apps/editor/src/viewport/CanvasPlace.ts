import { watchPixelRatio } from '@farol/engine';

/** Keeps a canvas as large as its parent element. */
export class CanvasPlace {
  /** Width of the canvas (CSS pixels), at least 1; `height` likewise. */
  width = 1;
  height = 1;

  private readonly resizer = new ResizeObserver(() => this.measure());
  private readonly unwatch = watchPixelRatio(() => this.measure());

  /**
   * @param resized - called when the element's size or the screen's pixel ratio may have changed; `width` and `height`
   *   are set
   */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly resized: () => void,
  ) {}

  /** Adds the canvas to an element, and follows its size. */
  attach(parent: HTMLElement): void {
    parent.append(this.canvas);
    this.resizer.observe(parent);
    this.measure();
  }

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
