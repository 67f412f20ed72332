import type { PictureRenderer } from '@farol/engine';
import type { FarolEffect } from '@farol/renderer';
import { Registry } from '../model/Registry';

/** An effect of a plugin, as the Frame panel shows it. */
export interface AddedEffect {
  readonly id: string;
  readonly label: string;
  /** One line. */
  readonly help: string;
  /** A new effect, made when it is first switched on. */
  make(): FarolEffect;
}

/** Effects of plugins; scenes ask for them by name. They come before those that smooth edges. */
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
