import type { Frame } from '../../frame/Frame';
import { forwardTwins } from '../../forward/forwardTwin';
import { resetObject } from './objectAttribute';
import { drawLayers } from './drawLayers';
import type { LitMaterialsPass } from './LitMaterialsPass';
import type { Pass } from '../../frame/Pass';
import type { ThinGBufferPass } from './ThinGBufferPass';
import type { LightLoop } from '../../lighting/loops/LightLoop';

/**
 * Draws what is transparent, back to front: layers that are in the thin G-buffer by the light buffer, the others forward.
 * @see Kircher and Lawrance 2009, Inferred Lighting
 */
export class StippledPass implements Pass {
  readonly name = 'transparent';
  readonly reads = ['thin-gbuffer', 'scene-depth', 'light-buffer'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  private readonly forward: ReturnType<typeof forwardTwins>;

  /** @param loop microshader by which the others loop over the lights */
  constructor(
    private readonly surfaces: ThinGBufferPass,
    private readonly materials: LitMaterialsPass,
    loop: LightLoop,
  ) {
    this.forward = forwardTwins(loop);
  }

  render(frame: Frame): void {
    const { view, queue } = frame;
    if (queue.transparent.length === 0 || view === 'overdraw') return;
    frame.bindTarget();
    const stippled = this.materials.twins(view);
    const forward = this.forward(view);
    const onlyLit = view !== 'final' && view !== 'grid';
    const { items } = this.surfaces;
    let layer = 0;
    try {
      for (const item of queue.transparent) {
        if (this.surfaces.isStippled(item)) layer = drawLayers(frame, item, stippled, items.length, layer);
        else if (item.lit || !onlyLit) frame.drawForward(item, forward);
      }
    } finally {
      resetObject(frame.gl);
    }
  }

  dispose(): void {}
}
