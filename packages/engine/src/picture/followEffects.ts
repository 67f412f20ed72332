import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { Scene } from '../core/Scene';

/** The effects that scenes have brought into one renderer. */
interface OwnEffects {
  readonly required: RequiredEffect[];
  /** The renderer's effect for each entry of `required`. */
  readonly made: FarolEffect[];
  /** Effects whose late code is being fetched. */
  readonly loading: Set<RequiredEffect>;
}

const ownEffects = new WeakMap<FarolRenderer, OwnEffects>();
const nothing = (): void => {};

/**
 * Gives a renderer the effects that the scene's components need (`static effect` of their class), and removes those
 * that it was given for other scenes; an effect of the host's own is taken as it is. Call before each frame of
 * `renderer.render(scene.three, …)`; `App` does so by itself.
 * @param redraw - called when the code of an effect has come, for hosts that draw no frame unless asked to
 */
export function followEffects(renderer: FarolRenderer, scene: Scene, redraw: () => void = nothing): void {
  const { requiredEffects } = scene;
  let own = ownEffects.get(renderer);
  if (!own) ownEffects.set(renderer, (own = { required: [], made: [], loading: new Set() }));
  for (let i = 0; i < own.required.length; i++) {
    if (!requiredEffects.includes(own.required[i])) remove(renderer, own.made[i]);
  }
  for (let i = 0; i < requiredEffects.length; i++) add(renderer, own, requiredEffects[i], redraw);
}

function remove(renderer: FarolRenderer, effect: FarolEffect): void {
  if (renderer.effects.includes(effect)) renderer.effects = renderer.effects.filter((other) => other !== effect);
}

function add(renderer: FarolRenderer, own: OwnEffects, required: RequiredEffect, redraw: () => void): void {
  const { effectClass } = required;
  if (effectClass === null) return load(own, required, redraw);
  const { effects } = renderer;
  for (let i = 0; i < effects.length; i++) if (effects[i] instanceof effectClass) return;
  let place = own.required.indexOf(required);
  if (place < 0) {
    place = own.required.push(required) - 1;
    own.made.push(new effectClass());
  }
  renderer.effects = [own.made[place], ...effects];
}

function load({ loading }: OwnEffects, required: RequiredEffect, redraw: () => void): void {
  if (loading.has(required)) return;
  loading.add(required);
  required
    .load()
    // the component loads the same code, and tells of a failure
    .then(redraw, nothing)
    .finally(() => loading.delete(required));
}
