import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import { type EffectName, effects } from '@farol/renderer/effects';
import type { ViewerState } from './state/ViewerState';

/** The renderer's effects as the state says; an effect that is switched on again is the same object. */
export class ViewerEffects {
  private readonly made = new Map<EffectName, FarolEffect>();
  private active = '';

  constructor(private readonly farol: FarolRenderer) {}

  update({ aa, ao, oit }: ViewerState): void {
    const on: Partial<Record<EffectName, boolean>> = { 'ambient-occlusion': ao, 'order-independent-transparency': oit };
    const names = (Object.keys(effects) as EffectName[]).filter((name) => on[name] ?? name === aa);
    if (names.join() === this.active) return;
    this.active = names.join();
    this.farol.effects = names.map((name) => {
      let effect = this.made.get(name);
      if (effect === undefined) this.made.set(name, (effect = effects[name].make()));
      return effect;
    });
  }
}
