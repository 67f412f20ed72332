import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import type { FarolEffect } from './FarolEffect';

/** Of the host's list of effects those that can be drawn; what is left out is warned of once. */
export class EffectList {
  private asked: readonly FarolEffect[] = [];
  private count = 0;
  private several = false;
  private runs: readonly FarolEffect[] = [];
  private readonly told = new WeakSet<FarolEffect>();

  constructor(private readonly webgl: WebGLRenderer) {}

  /**
   * @param effects the host's list; given back as it is while nothing is left out
   * @param target what is drawn to
   */
  of(effects: readonly FarolEffect[], target: WebGLRenderTarget | null): readonly FarolEffect[] {
    const several = target !== null && target.textures.length > 1;
    if (effects === this.asked && effects.length === this.count && several === this.several) return this.runs;
    this.asked = effects;
    this.count = effects.length;
    this.several = several;
    this.runs = effects.every(this.canRun) ? effects : effects.filter(this.canRun);
    return this.runs;
  }

  private readonly canRun = (effect: FarolEffect): boolean => {
    const lacks = effect.lacks?.(this.webgl) ?? null;
    const apart = this.several && effect.takesPicture === true;
    if (lacks === null && !apart) return true;
    const reason = lacks === null ? 'the target has several textures' : `this device ${lacks}`;
    if (!this.told.has(effect)) console.warn(`Farol: ${effect.name} is left out, since ${reason}.`);
    this.told.add(effect);
    return false;
  };
}
