import { AudioSource } from '@farol/engine';
import { component, number } from '@farol/engine/fields';

/** Plays the AudioSource of its object when the object is struck hard. */
export default class Thud extends component({
  impulse: number(8, { unit: 'N·s', min: 0, step: 0.5, help: 'How hard the blow must be.' }),
}) {
  static override readonly help: string = 'A sound where something falls.';

  onCollisionEnter(event: { readonly impulse: number }): void {
    if (event.impulse >= this.impulse) this.gameObject.getComponent(AudioSource)?.play();
  }
}
