import type { PictureRenderer } from '@farol/engine';
import type { FarolEffect } from '@farol/renderer';
import { Registry } from '../model/Registry';

export interface AddedEffect {
  readonly id: string;
  readonly label: string;
  /** Short description shown in the Frame panel, one line. */
  readonly help: string;
  /** Creates the effect, when it is first switched on. */
  make(): FarolEffect;
}

/** Effects of plugins, which scenes switch on by name. They run before antialiasing effects. */
export class AddedEffects {
  readonly registry = new Registry<AddedEffect>('an effect', []);

  constructor(effects: Pick<PictureRenderer['effects'], 'added' | 'addedChanged'>) {
    this.registry.changed.subscribe(() => {
      effects.added.clear();
      for (const { id, make } of this.registry.list) effects.added.set(id, make);
      effects.addedChanged();
    });
  }
}
