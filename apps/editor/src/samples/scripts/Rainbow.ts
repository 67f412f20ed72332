import { component, number } from '@farol/engine/fields';
import { Color } from 'three';

const colour = new Color();

/** Moves through all hues: the light, and the mesh that shows the light. */
export default class Rainbow extends component({
  speed: number(0.1, { unit: 'Hz', step: 0.01, help: 'How often a second it runs through all hues.' }),
  hue: number(0, { min: 0, max: 1, step: 0.01, help: 'The hue that it begins with.' }),
}) {
  static override readonly help: string = 'A light of changing colour.';

  override update(_deltaSeconds: number, time: number): void {
    colour.setHSL((this.hue + this.speed * time) % 1, 1, 0.5);
    // simulate() sets a value that is shown and not saved
    this.gameObject.getComponent('Light')?.simulate('diffuse', [colour.r, colour.g, colour.b]);
    this.gameObject.getComponent('ObjectRenderer')?.simulate('colour', [colour.r, colour.g, colour.b]);
  }
}
