import { Light } from '@farol/engine';
import { component, custom, number } from '@farol/engine/fields';
import { share } from './share';

/** Makes the light of its object flicker like a flame; depends on time only, so every run is the same. */
export class Flicker extends component({
  depth: custom(share, 0.4, { help: 'Part of the light that comes and goes.' }),
  rate: number(6, { unit: 'Hz', min: 0, step: 0.5, help: 'How fast it flickers.' }),
}) {
  static override readonly typeName: string = 'Flicker';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A light that flickers while the scene plays.';

  override update(_deltaSeconds: number, time: number): void {
    const light = this.gameObject.getComponent(Light);
    if (!light) return;
    const beat = time * this.rate;
    const wave = (Math.sin(beat * 2.1) + Math.sin(beat * 3.7 + 1) + Math.sin(beat * 7.3 + 2)) / 6 + 0.5;
    // changes three's light rather than the field, since simulation must not edit fields
    light.three.intensity = light.intensity * (time === 0 ? 1 : 1 - this.depth * wave);
  }
}
