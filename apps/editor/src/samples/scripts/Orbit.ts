import { component, number } from '@farol/engine/fields';

/** Circles round the vertical axis of its parent from where it was put. */
export default class Orbit extends component({
  speed: number(0.8, { unit: 'rad/s', step: 0.05, help: 'How fast it circles; below 0 the other way round.' }),
}) {
  static override readonly help: string = 'Circles round the axis of its parent.';

  override update(_deltaSeconds: number, time: number): void {
    const [x, y, z] = this.gameObject.transform.position;
    const turned = Math.atan2(z, x) + this.speed * time;
    const distance = Math.hypot(x, z);
    this.gameObject.object3D.position.set(Math.cos(turned) * distance, y, Math.sin(turned) * distance);
  }
}
