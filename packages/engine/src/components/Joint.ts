import type { Scene } from '../core/SceneGraph';
import { component } from '../fields/component';
import { jointFields } from '../physics/jointFields';
import { PhysicsSystem } from '../physics/PhysicsSystem';

/**
 * Ties the body of its object (that of the object itself or of the nearest one above) to that of another object, or to the
 * world, while the scene plays. Several may be on one object.
 */
export class Joint extends component(jointFields) {
  static override readonly typeName: string = 'Joint';
  static override readonly help: string = 'Ties a body to another: hinge, ball, slider, spring.';

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
