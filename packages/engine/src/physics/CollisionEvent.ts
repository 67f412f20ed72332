import type { Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import type { ColliderPart } from './PhysicsParts';

/**
 * Argument of a component's `onCollisionEnter(event)` and `onCollisionExit(event)`, and where one of the two colliders
 * is a sensor `onTriggerEnter(event)` and `onTriggerExit(event)`. They are called on the components of the object with
 * the collider, and of the object with the RigidBody that the collider belongs to.
 */
export interface CollisionEvent {
  readonly type: 'enter' | 'exit';
  /** The object that is touched: the one with the RigidBody, or the Collider's own where there is none. */
  readonly other: GameObject;
  /** The object that is called. */
  readonly object: GameObject;
  /** The collider that touches; null for the body of a CharacterController. */
  readonly collider: ColliderPart | null;
  /** The collider that is touched; null for the body of a CharacterController. */
  readonly otherCollider: ColliderPart | null;
  /** Whether one of the two colliders is a sensor, which stops nothing. */
  readonly isSensor: boolean;
  /** A point of the world where they touch (m); null for sensors and at the exit. */
  readonly point: Vector3 | null;
  /** Unit vector of the world from the other object to this one; null for sensors and at the exit. */
  readonly normal: Vector3 | null;
  /** Impulse of the first contact (N·s); 0 for sensors and at the exit. */
  readonly impulse: number;
}

/** The methods of components that hear of collisions. */
export const collisionMethods = ['onCollisionEnter', 'onCollisionExit', 'onTriggerEnter', 'onTriggerExit'] as const;
