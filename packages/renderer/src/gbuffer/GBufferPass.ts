import type { Material } from 'three';
import type { Frame } from '../frame/Frame';
import { GBuffer } from './GBuffer';
import { attachmentIndex } from './gbufferNames';
import { shadingModelOf } from './shadingModel';
import { gbufferTwin } from './gbufferTwins';
import type { TwinKind } from '../materials/TwinKind';
import type { Pass } from '../frame/Pass';

/** How lit and unlit meshes are drawn for the views of the G-buffer. */
export interface GBufferViewTwins {
  readonly lit: TwinKind;
  readonly unlit: TwinKind;
}

/**
 * Draws the opaque items that the G-buffer can hold into it, all attachments in one pass.
 * @see Saito and Takahashi 1990; Hargreaves and Harris 2004, Deferred Shading; thesis 2.2.3.1 and 3.1.1
 */
export class GBufferPass implements Pass {
  readonly name = 'g-buffer';
  readonly reads = [] as const;
  readonly writes = ['gbuffer'] as const;
  gbuffer: GBuffer | null = null;

  /** @param forView kinds that write every mesh, with emissive alone in the first attachment; then none is marked as drawn */
  constructor(private readonly forView: GBufferViewTwins | null = null) {}

  get bytes(): number {
    return this.gbuffer?.bytes ?? 0;
  }

  render(frame: Frame): void {
    // what stores distances goes on to: cameras may take turns
    const stores = this.forView === null && (frame.storesDistance || this.gbuffer?.storesDistance === true);
    if (this.gbuffer?.layout !== frame.gbufferLayout || this.gbuffer.storesDistance !== stores) this.dispose();
    this.gbuffer ??= new GBuffer(frame.webgl, frame.gbufferLayout, stores);
    this.gbuffer.setSize(frame.width, frame.height);
    frame.bind(this.gbuffer.target);
    // where nothing is drawn, depth 1 says so: what the other attachments hold there is never shown, and a clear costs as much as a draw
    frame.clear(0, true);
    // but what is drawn as far off: there flags say so
    if (frame.queue.reachesFar) frame.clearOne(attachmentIndex.albedo);
    for (const item of frame.queue.opaque) {
      if (this.forView) {
        if (!item.plain) continue;
        if (item.lit && !(item.material as Material & { isShaderMaterial?: boolean }).isShaderMaterial)
          frame.drawTwin(item, this.forView.lit);
        else if ((item.material as Material & { isMeshBasicMaterial?: boolean }).isMeshBasicMaterial)
          frame.drawTwin(item, this.forView.unlit);
      } else if (item.splits && !item.layered && shadingModelOf(item.material) !== null) {
        frame.drawTwin(item, gbufferTwin);
        item.drawn = true;
      }
    }
  }

  dispose(): void {
    this.gbuffer?.dispose();
    this.gbuffer = null;
  }
}
