import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import type { FarolEffect } from './FarolEffect';

/** Of the host's list of effects those that can be drawn; what is left out is warned of once. */
export class EffectList {
  private asked: readonly FarolEffect[] = [];
  private count = 0;
  private several = false;
  private runs: readonly FarolEffect[] = [];
  private readonly told = new WeakSet<FarolEffect>();
  /** All that were ever asked for: those that are left out of the list stay the host's, which may use them again. */
  private met: WeakRef<FarolEffect>[] = [];

  constructor(private readonly webgl: WebGLRenderer) {}

  /**
   * @param effects the host's list; given back as it is while nothing is left out
   * @param target what is drawn to
   */
  of(effects: readonly FarolEffect[], target: WebGLRenderTarget | null): readonly FarolEffect[] {
    const several = target !== null && target.textures.length > 1;
    if (effects === this.asked && effects.length === this.count && several === this.several) return this.runs;
    this.meet(effects);
    this.asked = effects;
    this.count = effects.length;
    this.several = several;
    this.runs = effects.every(this.canRun) ? effects : effects.filter(this.canRun);
    return this.runs;
  }

  /** Has all that were met free what they hold; they make it anew when they are drawn again. */
  dispose(): void {
    for (const reference of this.met) reference.deref()?.dispose();
  }

  private meet(effects: readonly FarolEffect[]): void {
    const known = new Set<unknown>();
    this.met = this.met.filter((reference) => known.add(reference.deref()) && reference.deref() !== undefined);
    for (const effect of effects) if (!known.has(effect)) this.met.push(new WeakRef(effect));
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
