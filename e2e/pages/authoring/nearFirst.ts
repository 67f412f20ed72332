import {
  DeferredOutputPass,
  fitsGBuffer,
  forwardTail,
  type Frame,
  GBufferTarget,
  gbufferTwin,
  LightVolumesPass,
  type Pass,
  type RenderItem,
  type Technique,
} from '@farol/renderer/authoring';

const byDistance = (a: RenderItem, b: RenderItem): number => a.z - b.z;

/** Fills the G-buffer from near to far, whatever the materials: what is hidden is not shaded. */
class NearFirstPass implements Pass {
  readonly name = 'surfaces, near first';
  readonly reads = [] as const;
  readonly writes = ['gbuffer', 'scene-depth'] as const;
  private readonly target = new GBufferTarget();
  private readonly items: RenderItem[] = [];

  get bytes(): number {
    return this.target.bytes;
  }

  render(frame: Frame): void {
    const { items } = this;
    items.length = 0;
    for (const item of frame.queue.opaque) if (fitsGBuffer(item)) items.push(item);
    items.sort(byDistance);
    const gbuffer = this.target.begin(frame);
    for (const item of items) {
      frame.drawTwin(item, gbufferTwin);
      item.drawn = true; // else it is drawn forward too
    }
    frame.resources.put('gbuffer', gbuffer);
    frame.resources.put('scene-depth', gbuffer.depth);
  }

  dispose(): void {
    this.target.dispose();
  }
}

export const nearFirst: Technique = {
  label: 'Deferred, near first',
  help: 'Deferred shading that draws near surfaces before far ones.',
  lightOrder: 'by-volume',
  needsFloatTargets: true,
  fills: 'every-pixel',
  passes: () => [new NearFirstPass(), new LightVolumesPass(), new DeferredOutputPass(), ...forwardTail('lightLoopAll')],
};
