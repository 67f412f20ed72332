import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import { loadEffects } from '@farol/renderer/effects';
import { effectEntries, effectParameters, switchName } from './state/effectParameters';
import type { ViewerState } from './state/ViewerState';

/** The renderer's effects for the viewer's state; an effect that is switched on again is the same object. */
export class ViewerEffects {
  private readonly all = new Map<string, FarolEffect>();
  private active = '';

  constructor(private readonly farol: FarolRenderer) {}

  /** Fetches the code of all effects, then applies the state. @throws Error (as a rejection) when it cannot be fetched */
  async fetch(state: ViewerState): Promise<void> {
    for (const [name, Effect] of Object.entries(await loadEffects())) this.all.set(name, new Effect());
    this.update(state);
  }

  update({ aa, effects }: ViewerState): void {
    const names: string[] = [];
    for (const [name, effect] of this.all) {
      const entry = effectEntries[name];
      for (const [number, { kind, property }] of Object.entries(entry.fields ?? {}))
        if (kind === 'number')
          Object.assign(effect, { [property]: effects[number] ?? effectParameters[number].default });
      if (name === aa || effects[switchName(entry)] === true) names.push(name);
    }
    if (names.join() === this.active) return;
    this.active = names.join();
    this.farol.effects = names.map((name) => this.all.get(name)!);
  }
}
