import type { Scene } from '../core/SceneGraph';
import { component } from '../fields/component';
import { colliderFields } from '../physics/colliderFields';
import { PhysicsSystem } from '../physics/PhysicsSystem';

/**
 * A shape that bodies collide with. It belongs to the RigidBody of its object or of the nearest object above, several
 * together making one shape; without one it stands fixed where its object is. Sizes follow the object's scale.
 */
export class Collider extends component(colliderFields) {
  static override readonly typeName: string = 'Collider';
  static override readonly help: string = 'A shape that bodies collide with.';

  override onEnterScene(scene: Scene): void {
    scene.system(PhysicsSystem).componentChanged(this);
  }

  override onLeaveScene(scene: Scene): void {
    scene.system(PhysicsSystem).componentChanged(this);
  }

  override onFieldChanged(): void {
    this.scene?.system(PhysicsSystem).componentChanged(this);
  }

  override onActiveChanged(): void {
    this.scene?.system(PhysicsSystem).componentChanged(this);
  }
}
