import { component, number, object } from '@farol/engine/fields';
import { Vector3 } from 'three';

const from = new Vector3();
const to = new Vector3();

/** Walks from point to point in a loop, facing its direction. */
export default class Patrol extends component({
  way: object(null, { help: 'The object whose children are the points, in their order.' }),
  speed: number(1.4, { unit: 'm/s', min: 0, step: 0.1, help: 'How fast it goes.' }),
  pause: number(0.5, { unit: 's', min: 0, step: 0.1, help: 'How long it stays at each point.' }),
}) {
  static override readonly help: string = 'Walks round a way of points.';

  private next = 0;
  private rest = 0;

  override start(): void {
    this.next = this.rest = 0;
  }

  override update(deltaSeconds: number): void {
    const points = (this.way === null ? null : this.scene!.findById(this.way))?.children ?? [];
    if (points.length === 0) return;
    this.rest -= deltaSeconds;
    if (this.rest > 0) return;
    const { object3D } = this.gameObject;
    points[this.next % points.length].object3D.getWorldPosition(to);
    object3D.parent?.worldToLocal(to);
    from.copy(object3D.position);
    const left = from.distanceTo(to);
    if (left < 0.01) {
      this.next = (this.next + 1) % points.length;
      this.rest = this.pause;
      return;
    }
    object3D.position.lerpVectors(from, to, Math.min(1, (this.speed * deltaSeconds) / left));
    // the front is -Z
    if (Math.hypot(to.x - from.x, to.z - from.z) > 0.01)
      object3D.rotation.set(0, Math.atan2(from.x - to.x, from.z - to.z), 0);
  }
}
