import { colliderFields } from '../physics/colliderFields';
import { physicsComponent } from '../physics/physicsComponent';

/**
 * A shape that bodies collide with. It belongs to the RigidBody of its object or of the nearest ancestor, as part of
 * the body's shape; without a RigidBody it is fixed at its object. Sizes follow the object's scale.
 */
export class Collider extends physicsComponent(colliderFields) {
  static override readonly typeName: string = 'Collider';
  static override readonly icon: string = 'collider';
  static override readonly help: string = 'A shape that bodies collide with.';
}
