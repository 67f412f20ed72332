import type { Material } from 'three';
import type { Frame } from '../Frame';
import { GBuffer } from '../gbuffer/GBuffer';
import { shadingModelOf } from '../gbuffer/shadingModel';
import { gbufferTwin, gbufferUnlitTwin, gbufferViewTwin } from '../materials/gbufferTwins';
import type { Pass } from './Pass';

/**
 * Draws the opaque items that the G-buffer can hold into it, all attachments in one pass.
 * @see Saito and Takahashi 1990; Hargreaves and Harris 2004, Deferred Shading; thesis 2.2.3.1 and 3.1.1
 */
export class GBufferPass implements Pass {
  readonly name = 'g-buffer';
  readonly reads = [] as const;
  readonly writes = ['gbuffer'] as const;
  gbuffer: GBuffer | null = null;

  /** @param forView true writes every mesh, and emissive alone in the first attachment; marks nothing as drawn */
  constructor(private readonly forView = false) {}

  get bytes(): number {
    return this.gbuffer?.bytes ?? 0;
  }

  render(frame: Frame): void {
    const withIndirect = frame.withIndirect && !this.forView;
    if (this.gbuffer !== null && (this.gbuffer.indirect !== null) !== withIndirect) this.dispose();
    this.gbuffer ??= new GBuffer(frame.webgl, withIndirect);
    this.gbuffer.setSize(frame.width, frame.height);
    frame.bind(this.gbuffer.target);
    // where nothing is drawn, depth 1 says so: what the other attachments hold there is never shown, and a clear costs as much as a draw
    frame.clear(0, true);
    for (const item of frame.queue.opaque) {
      if (!item.plain || (item.layered && !this.forView)) continue;
      if (this.forView) {
        if (item.lit && !(item.material as Material & { isShaderMaterial?: boolean }).isShaderMaterial)
          frame.drawTwin(item, gbufferViewTwin);
        else if ((item.material as Material & { isMeshBasicMaterial?: boolean }).isMeshBasicMaterial)
          frame.drawTwin(item, gbufferUnlitTwin);
      } else if (item.lit && shadingModelOf(item.material) !== null) {
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
