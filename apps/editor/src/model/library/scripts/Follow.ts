import type { GameObject } from '@farol/engine';
import { component, number, object } from '@farol/engine/fields';
import { Vector3 } from 'three';

const wanted = new Vector3();

/** Moves its object towards another one, and keeps a distance. */
export default class Follow extends component({
  target: object(null, { help: 'The object that it follows; the one with the tag “player” when none is chosen.' }),
  distance: number(1.5, { unit: 'm', min: 0, step: 0.1, help: 'How near it comes.' }),
  height: number(1.8, { unit: 'm', step: 0.1, help: 'How high it is above the other’s origin.' }),
  speed: number(2, { unit: '1/s', min: 0, step: 0.1, help: 'Part of the way that it makes up in a second.' }),
}) {
  static override readonly help: string = 'Follows an object, or the player.';

  private player: GameObject | null = null;

  override start(): void {
    this.player = null;
    this.scene!.traverse((each) => {
      if (!this.player && each.tags.includes('player')) this.player = each;
    });
  }

  override lateUpdate(deltaSeconds: number): void {
    const other = this.target === null ? this.player : this.scene!.findById(this.target);
    if (!other) return;
    const { object3D } = this.gameObject;
    other.object3D.getWorldPosition(wanted);
    wanted.y += this.height;
    object3D.parent?.worldToLocal(wanted);
    const way = wanted.sub(object3D.position);
    const length = Math.hypot(way.x, way.z);
    // within the distance only the height follows
    const part = length > this.distance ? (length - this.distance) / length : 0;
    const share = 1 - Math.exp(-this.speed * deltaSeconds);
    object3D.position.x += way.x * part * share;
    object3D.position.y += way.y * share;
    object3D.position.z += way.z * part * share;
  }
}
