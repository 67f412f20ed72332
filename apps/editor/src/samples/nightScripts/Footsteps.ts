import { AudioSource } from '@farol/engine';
import { component, number } from '@farol/engine/fields';

/** Plays the AudioSource of its object at each step that the object takes over the ground. */
export default class Footsteps extends component({
  stride: number(0.8, { unit: 'm', min: 0.1, step: 0.05, help: 'Way from step to step.' }),
}) {
  static override readonly help: string = 'A sound at each step.';

  private x = 0;
  private z = 0;
  private way = 0;

  override start(): void {
    const { x, z } = this.gameObject.object3D.position;
    Object.assign(this, { x, z, way: 0 });
  }

  override lateUpdate(): void {
    const { x, z } = this.gameObject.object3D.position;
    this.way += Math.hypot(x - this.x, z - this.z);
    this.x = x;
    this.z = z;
    if (this.way < this.stride) return;
    this.way %= this.stride;
    this.gameObject.getComponent(AudioSource)?.play();
  }
}
