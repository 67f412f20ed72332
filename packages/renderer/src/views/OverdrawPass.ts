import { HalfFloatType, Vector2, type Texture } from 'three';
import type { Frame } from '../frame/Frame';
import { depthTwin, hasDepthTwin } from '../materials/depthTwin';
import { canCountOverdraw, overdrawTwin } from '../materials/overdrawTwin';
import type { RenderItem } from '../frame/RenderItem';
import { FullscreenPass } from '../gpu/FullscreenPass';
import { PassTarget } from '../gpu/PassTarget';

/** Counts the shadings of each pixel, in the technique's order of draws, for the view 'overdraw'. */
export class OverdrawPass {
  private readonly target = new PassTarget({ type: HalfFloatType, depthBuffer: true });
  private readonly counts = new FullscreenPass({
    program: 'count view',
    fragment: 'countView',
    shared: 'all',
    asThree: true,
    uniforms: { farol_overdrawMap: { value: null as Texture | null }, farol_offset: { value: new Vector2() } },
  });

  get bytes(): number {
    return this.target.bytes;
  }

  /** @param depthFirst - whether the technique draws depth before it shades */
  render(frame: Frame, depthFirst: boolean): void {
    const target = this.target.of(frame.width, frame.height);
    frame.bind(target);
    frame.clear(1, true);
    if (depthFirst) {
      for (const item of frame.queue.opaque) {
        if (item.route === 'split' && hasDepthTwin(item.material)) frame.drawTwin(item, depthTwin);
      }
    }
    this.count(frame, depthFirst ? frame.queue.opaque : frame.queue.beginOrder());
    frame.queue.endOrder();
    this.count(frame, frame.queue.transmissive);
    this.count(frame, frame.queue.transparent);
    frame.resources.put('overdraw', target.texture);
  }

  /** Draws the counts as a heat map, for techniques that have no output pass. */
  show(frame: Frame): void {
    const { uniforms } = this.counts;
    uniforms.farol_overdrawMap.value = frame.resources.get('overdraw');
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    frame.bindTarget();
    this.counts.draw(frame);
  }

  dispose(): void {
    this.target.dispose();
    this.counts.dispose();
  }

  private count(frame: Frame, items: readonly RenderItem[]): void {
    for (const item of items) if (canCountOverdraw(item.material)) frame.drawTwin(item, overdrawTwin);
  }
}
