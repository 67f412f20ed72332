import type { WebGLRenderer } from 'three';
import type { FarolEffect } from './FarolEffect';

/** Of the host's list of effects those that the device can run; what is left out is warned of once. */
export class EffectList {
  private asked: readonly FarolEffect[] = [];
  private count = 0;
  private runs: readonly FarolEffect[] = [];
  private readonly told = new WeakSet<FarolEffect>();

  constructor(private readonly webgl: WebGLRenderer) {}

  /** @param effects the host's list; the same array while nothing is left out */
  of(effects: readonly FarolEffect[]): readonly FarolEffect[] {
    if (effects === this.asked && effects.length === this.count) return this.runs;
    this.asked = effects;
    this.count = effects.length;
    this.runs = effects.every(this.canRun) ? effects : effects.filter(this.canRun);
    return this.runs;
  }

  private readonly canRun = (effect: FarolEffect): boolean => {
    const lacks = effect.lacks?.(this.webgl) ?? null;
    if (lacks === null) return true;
    if (!this.told.has(effect)) console.warn(`Farol: ${effect.name} is left out, since this device ${lacks}.`);
    this.told.add(effect);
    return false;
  };
}
