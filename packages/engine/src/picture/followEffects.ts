import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { Scene } from '../core/Scene';

/** Effects that this module has added to one renderer. */
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
 * Adds the effects that a scene's components need (`static effect` of their class) to a renderer, and removes those
 * added for other scenes; an effect of the same class that the host has added is used instead. Call before each
 * `renderer.render(scene.three, …)`; `App` does so itself.
 * @param redraw - called once the code of an effect is loaded, for hosts that draw on demand
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
    // the component loads the same code, and reports a failure
    .then(redraw, nothing)
    .finally(() => loading.delete(required));
}
