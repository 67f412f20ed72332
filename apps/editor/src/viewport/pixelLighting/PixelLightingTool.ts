import { Signal, t } from '@farol/editing';
import { explainPixel } from '@farol/renderer/pixel-lighting';
import type { Tool } from '../../model/Tools';
import { DragReadout } from '../handles/DragReadout';
import { drawsFloats } from '../drawsFloats';
import { PictureClicks } from '../PictureClicks';
import type { Viewport } from '../Viewport';
import { type PixelReading, readPixel } from './PixelReading';

/** Tool that lists the lights that reach a clicked pixel. */
export class PixelLightingTool implements Tool {
  readonly id = 'pixel-lighting';
  /** Emits when a pixel was analysed, and on progress. */
  readonly changed = new Signal();
  /** The reading of the last pixel; null before the first. */
  reading: PixelReading | null = null;
  /** Progress of the analysis, 0 to 1; null while there is none. */
  progress: number | null = null;
  private readonly clicks: PictureClicks;
  private readonly readout: DragReadout;
  private work: AbortController | null = null;

  /** @throws Error naming the missing feature of the device */
  constructor(private readonly viewport: Viewport) {
    if (!drawsFloats(viewport.webgl))
      throw new Error(t('Light cannot be measured: this device cannot draw to float colour buffers.'));
    this.clicks = new PictureClicks(viewport, (x, y) => this.explain(x, y));
    this.readout = new DragReadout(viewport.canvas);
  }

  end(): void {
    this.cancel();
    this.clicks.end();
    this.readout.markAt(null);
  }

  /** Cancels the analysis of a pixel. */
  cancel(): void {
    this.work?.abort();
  }

  /** Analyses the pixel in the middle of the active view. */
  explainMiddle(): Promise<void> {
    const { left, top, width, height } = this.viewport.bounds;
    return this.explain(left + width / 2, top + height / 2);
  }

  /** Analyses the pixel at a point of the page (CSS pixels). The scene is not advanced meanwhile. */
  async explain(x: number, y: number): Promise<void> {
    const { viewport } = this;
    const { bounds, canvas, camera, farol, loop, document } = viewport;
    const { left, top, width, height } = bounds;
    const corner = canvas.getBoundingClientRect();
    this.cancel();
    const work = (this.work = new AbortController());
    const { signal } = work;
    this.readout.markAt({ x: x - corner.left, y: y - corner.top });
    this.tell(0);
    const ratio = viewport.webgl.getPixelRatio();
    const size = { width: Math.round(width * ratio), height: Math.round(height * ratio) };
    const pointer = { x: ((x - left) / width) * 2 - 1, y: 1 - ((y - top) / height) * 2 };
    const { scene } = document;
    loop.stop();
    try {
      viewport.picture.follow(scene);
      const onProgress = (done: number): void => this.tell(done);
      const lighting = await explainPixel(farol, scene.three, camera, pointer, { size, signal, onProgress });
      if (!signal.aborted) this.reading = readPixel(lighting, scene, { camera, ...size });
    } catch (error) {
      if (!signal.aborted) throw error;
    } finally {
      // skipped after a later click, which has stopped the frame loop for its own analysis and starts it again itself
      if (this.work === work) {
        this.work = null;
        loop.start();
        viewport.invalidate();
        this.tell(null);
      }
    }
  }

  private tell(progress: number | null): void {
    this.progress = progress;
    this.changed.emit();
  }
}
