import { Signal, t } from '@farol/editing';
import { evOfIlluminance } from '@farol/engine/photometry';
import type { Tool } from '../../model/Tools';
import { DragReadout } from '../handles/DragReadout';
import { drawsFloats } from '../drawsFloats';
import { PictureClicks } from '../PictureClicks';
import type { Viewport } from '../Viewport';
import { IlluminancePicture } from './IlluminancePicture';

/** Light that falls on a surface at a point, as measured. */
export interface LightReading {
  /** Illuminance (lx). */
  readonly illuminance: number;
  /** Exposure value at ISO 100, as of an incident light meter; -Infinity in the dark. */
  readonly value: number;
}

/** Measures illuminance (lx) and exposure value at a clicked point of the picture. */
export class LightMeterTool implements Tool {
  readonly id = 'light-meter';
  /** Emits when a point was measured. */
  readonly changed = new Signal();
  /** The last reading; null before the first one, and after a click that hit nothing. */
  reading: LightReading | null = null;
  private readonly picture: IlluminancePicture;
  private readonly readout: DragReadout;
  private readonly clicks: PictureClicks;
  private hasEnded = false;

  /** @throws Error naming the missing feature of the device */
  constructor(private readonly viewport: Viewport) {
    const { canvas, webgl } = viewport;
    if (!drawsFloats(webgl))
      throw new Error(t('Light cannot be measured: this device cannot draw to float colour buffers.'));
    this.picture = new IlluminancePicture(webgl, () => {});
    this.readout = new DragReadout(canvas);
    this.clicks = new PictureClicks(viewport, (x, y) => this.measure(x, y));
  }

  end(): void {
    this.hasEnded = true;
    this.clicks.end();
    this.readout.hide();
    this.readout.markAt(null);
    this.picture.dispose();
  }

  /** Measures at a point of the page (CSS pixels). */
  async measure(x: number, y: number): Promise<void> {
    const { viewport, picture } = this;
    const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
    const { scene } = viewport.document;
    picture.draw(scene, viewport.camera);
    // waits until the code that some kinds of lights need is fetched; then the scene is drawn again
    await picture.farol.ready;
    if (this.hasEnded) return;
    picture.draw(scene, viewport.camera);
    const illuminance = await picture.readAt((x - left) / width, 1 - (y - top) / height);
    if (this.hasEnded || illuminance === null) return;
    this.reading = { illuminance, value: evOfIlluminance(illuminance) };
    this.readout.markAt({ x: x - left, y: y - top });
    this.changed.emit();
  }
}
