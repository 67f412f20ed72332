import { jointFields } from '../physics/jointFields';
import { physicsComponent } from '../physics/physicsComponent';

/**
 * Joins the body of its object (or of the nearest ancestor with a body) to another object's body, or to the world,
 * while the scene plays. An object may have several.
 */
export class Joint extends physicsComponent(jointFields) {
  static override readonly typeName: string = 'Joint';
  static override readonly icon: string = 'joint';
  static override readonly help: string = 'Ties a body to another: hinge, ball, slider, spring.';
}
