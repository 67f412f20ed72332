import { type MeshStandardMaterial, type Scene, UVMapping } from 'three';
import type { Frame } from '../../frame/Frame';
import { fitsGBuffer, GBufferTarget } from './GBufferTarget';
import { exceedsGBuffer } from '../../gbuffer/exceedsGBuffer';
import { gbufferTwin } from './gbufferTwins';
import type { Pass } from '../../frame/Pass';

/**
 * Draws the opaque items that the G-buffer can hold into it, all attachments in one pass.
 * @see Saito and Takahashi 1990; Hargreaves and Harris 2004, Deferred Shading; thesis 2.2.3.1 and 3.1.1
 */
export class GBufferPass implements Pass {
  readonly name = 'g-buffer';
  readonly reads = [] as const;
  readonly writes = ['gbuffer', 'scene-depth'] as const;
  private readonly target = new GBufferTarget();

  get bytes(): number {
    return this.target.bytes;
  }

  render(frame: Frame): void {
    const gbuffer = this.target.begin(frame);
    // three blends an environment with UVMapping into the lit colour of Lambert and Phong materials, as it does cube maps
    const blends = (frame.scene as Scene).environment?.mapping === UVMapping;
    for (const item of frame.queue.beginOrder()) {
      if (!fitsGBuffer(item, frame.isLite) || exceedsGBuffer(item.material, frame.lights)) continue;
      if (blends && !(item.material as MeshStandardMaterial).isMeshStandardMaterial) continue;
      frame.drawTwin(item, gbufferTwin);
      item.drawn = true;
    }
    frame.queue.endOrder();
    frame.resources.put('gbuffer', gbuffer);
    frame.resources.put('scene-depth', gbuffer.depth);
  }

  dispose(): void {
    this.target.dispose();
  }
}
