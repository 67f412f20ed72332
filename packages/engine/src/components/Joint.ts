import { jointFields } from '../physics/jointFields';
import { physicsComponent } from '../physics/physicsComponent';

/**
 * Ties the body of its object (that of the object itself or of the nearest one above) to that of another object, or to the
 * world, while the scene plays. Several may be on one object.
 */
export class Joint extends physicsComponent(jointFields) {
  static override readonly typeName: string = 'Joint';
  static override readonly icon: string = 'joint';
  static override readonly help: string = 'Ties a body to another: hinge, ball, slider, spring.';
}
