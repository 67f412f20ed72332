import type { Frame } from '../../frame/Frame';
import { forwardTwins } from '../../materials/forwardTwin';
import { resetObject } from './objectAttribute';
import { drawLayers } from './drawLayers';
import type { Pass } from '../../frame/Pass';
import type { LightLoop } from '../../materials/LightLoop';

/**
 * Draws transparent items, back to front: layers in the thin G-buffer are lit by the light buffer, the others forward.
 * @see Kircher and Lawrance 2009, Inferred Lighting
 */
export class StippledPass implements Pass {
  readonly name = 'transparent';
  readonly reads = ['thin-gbuffer', 'light-buffer'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  private readonly forward: ReturnType<typeof forwardTwins>;

  /** @param loop - microshader by which layers outside of the thin G-buffer loop over the lights */
  constructor(loop: LightLoop) {
    this.forward = forwardTwins(loop);
  }

  render(frame: Frame): void {
    const { view, queue } = frame;
    if (queue.transparent.length === 0 || view === 'overdraw') return;
    const surfaces = frame.resources.get('thin-gbuffer');
    const stippled = frame.resources.get('light-buffer').twins(view);
    const forward = this.forward(view);
    const onlyLit = view !== 'final' && view !== 'grid';
    frame.bindTarget();
    let layer = 0;
    try {
      for (const item of queue.transparent) {
        if (surfaces.isStippled(item)) layer = drawLayers(frame, item, stippled, surfaces.items.length, layer);
        else if (item.shading === 'lit' || !onlyLit) frame.drawForward(item, forward);
      }
    } finally {
      resetObject(frame.gl);
    }
  }

  dispose(): void {}
}
