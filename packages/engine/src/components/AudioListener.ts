import { number } from '@farol/editing/fields';
import { component } from '../core/Component';

/** Ear of a scene, facing the object's front; without an AudioListener the active camera is the ear. */
export class AudioListener extends component({
  volume: number(1, { min: 0, max: 1, step: 0.05, help: 'Loudness of everything that is heard.' }),
}) {
  static override readonly typeName: string = 'AudioListener';
  static override readonly icon: string = 'listener';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Where the scene is heard from; without one, the active camera.';
}
