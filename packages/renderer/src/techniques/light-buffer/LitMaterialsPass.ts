import { Vector2, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { LightBuffer } from '../../frame/LightBuffer';
import { resetObject, setObject } from './objectAttribute';
import { objectNumber } from './objectNumbers';
import type { Pass } from '../../frame/Pass';

/**
 * Draws the thin G-buffer's surfaces again, into the host's target with the thin G-buffer's depth; each material reads its
 * direct light from the light buffer.
 * @see Engel 2009, The Light Pre-Pass Renderer; Kircher and Lawrance 2009, Inferred Lighting; thesis 2.2.3.3.2
 */
export class LitMaterialsPass implements Pass {
  readonly name = 'output';
  readonly reads = ['thin-gbuffer', 'light-buffer', 'overdraw'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  /** Pass that shows the counts of the technique's light buffer; null until needed. */
  private counts: ReturnType<typeof countPass> | null = null;

  render(frame: Frame): void {
    const { items } = frame.resources.get('thin-gbuffer');
    const lights = frame.resources.get('light-buffer');
    frame.bindTarget();
    if (frame.view === 'overdraw') {
      this.showCounts(frame, lights);
      return;
    }
    const twins = lights.twins(frame.view);
    frame.beginOrder(); // the thin G-buffer's items are in this order
    try {
      for (let i = 0; i < items.length; i++) {
        setObject(frame.gl, objectNumber(i), 0);
        frame.drawTwin(items[i], twins.whole);
        items[i].drawn = true;
      }
    } finally {
      frame.queue.endOrder();
      resetObject(frame.gl);
    }
  }

  dispose(): void {
    this.counts?.dispose();
    this.counts = null;
  }

  private showCounts(frame: Frame, lights: LightBuffer): void {
    const counts = (this.counts ??= countPass(lights));
    counts.uniforms.farol_overdrawMap.value = frame.resources.find('overdraw') ?? null;
    counts.uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    counts.draw(frame);
  }
}

function countPass({ uniforms }: LightBuffer) {
  return new FullscreenPass({
    program: 'light buffer counts',
    fragment: 'lightBufferCounts',
    shared: 'all',
    asThree: true,
    uniforms: {
      ...uniforms,
      farol_overdrawMap: { value: null as Texture | null },
      farol_offset: { value: new Vector2() },
    },
  });
}
