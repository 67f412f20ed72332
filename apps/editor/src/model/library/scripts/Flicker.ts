import { Light } from '@farol/engine';
import { component, number } from '@farol/engine/fields';

/** Makes the lights of its object and of its descendants flicker. */
export default class Flicker extends component({
  depth: number(0.4, { min: 0, max: 1, step: 0.05, help: 'How much darker it gets at times: 0 not at all, 1 dark.' }),
  speed: number(6, { unit: 'Hz', min: 0, step: 0.5, help: 'How often it changes.' }),
}) {
  static override readonly help: string = 'Light that burns as a flame does.';

  override update(_deltaSeconds: number, time: number): void {
    // three sine waves of unrelated periods, with a phase for each object
    const { x, z } = this.gameObject.object3D.position;
    const t = (time + x * 3.1 + z * 5.7) * this.speed;
    const wave = (Math.sin(t * 1.9) + Math.sin(t * 3.7 + 1) + Math.sin(t * 7.3 + 2)) / 3;
    const factor = 1 - this.depth * (0.5 + 0.5 * wave);
    this.gameObject.traverse((object) => {
      const light = object.getComponent(Light);
      if (!light) return;
      const steady = light.getAuthored('intensity') as number;
      // simulate() sets a value that is shown but not saved
      light.simulate('intensity', steady * factor);
    });
  }
}
