import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import { decalCode, loadDecalCode } from '../components/decalCode';
import type { Scene } from '../core/Scene';

const made = new WeakMap<FarolRenderer, FarolEffect>();
const waiting = new WeakSet<FarolRenderer>();

/**
 * Has the effect that draws decals in a renderer while a scene has some; one of the host's own is taken as it is. Call before
 * each frame of `renderer.render(scene.three, …)`; `App` does so by itself.
 * @param redraw called when the code of decals has come, for who draws no frame unless asked to
 */
export function followDecals(renderer: FarolRenderer, scene: Scene, redraw: () => void = () => {}): void {
  const own = made.get(renderer);
  const has = own !== undefined && renderer.effects.includes(own);
  if (scene.decals.length === 0) {
    if (has) renderer.effects = renderer.effects.filter((effect) => effect !== own);
    return;
  }
  const code = decalCode();
  if (code === null) {
    if (waiting.has(renderer)) return;
    waiting.add(renderer);
    loadDecalCode()
      // the decals themselves have asked before, and tell of a failure
      .then(redraw, () => {})
      .finally(() => waiting.delete(renderer));
  } else if (!has && !renderer.effects.some((effect) => effect instanceof code.Decals)) {
    const decals = own ?? new code.Decals();
    made.set(renderer, decals);
    renderer.effects = [decals, ...renderer.effects];
  }
}
