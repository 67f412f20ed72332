import type { SMAA } from '../../effects/antialiasing/SMAA';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { Lazy } from '../../frame/Lazy';
import type { Technique } from '../../techniques/Technique';

const smaaCode = new Lazy(
  'smaa',
  () => import('../../effects/antialiasing/SMAA'),
  'edges are drawn from one sample a pixel',
);

/**
 * SMAA where a canvas or target asks for samples (`antialias: true`, `samples`) that the technique does not draw: those with
 * a G-buffer fill it from one sample a pixel. What the others draw is multisampled as stock three's, and left alone.
 */
export class SmoothEdges implements FarolEffect {
  readonly name = 'SMAA';
  readonly takesPicture = true;
  private smaa: SMAA | null = null;
  private isOn = false;

  get bytes(): number {
    return this.smaa?.bytes ?? 0;
  }

  picked(frame: Frame, technique: Technique): void {
    this.isOn = false;
    if (frame.samples === 0 || technique.fills !== 'every-pixel') return;
    this.smaa ??= smaaCode.use(({ SMAA }) => new SMAA());
    if (this.smaa === null) return;
    this.isOn = true;
    this.smaa.begin(frame);
  }

  end(frame: Frame): void {
    if (this.isOn) this.smaa!.end(frame);
  }

  dispose(): void {
    this.smaa?.dispose();
  }
}
