import { component, number } from '@farol/engine/fields';
import { ripple } from './ripple';

/** Moves the children of its object up and down as a wave that runs from the middle. */
export default class Wave extends component({
  height: number(0.8, { unit: 'm', step: 0.05, help: 'How far up and down they go.' }),
  length: number(5, { unit: 'm', min: 0.1, step: 0.1, help: 'From crest to crest.' }),
  speed: number(0.4, { unit: 'Hz', step: 0.05, help: 'Waves a second.' }),
}) {
  static override readonly help: string = 'A wave through the children of its object.';

  override update(_deltaSeconds: number, time: number): void {
    for (const child of this.gameObject.children) {
      const [x, y, z] = child.transform.position;
      // what a script moves is simulation: Stop puts it back
      child.object3D.position.y = y + this.height * ripple(Math.hypot(x, z) / this.length - time * this.speed);
    }
  }
}
