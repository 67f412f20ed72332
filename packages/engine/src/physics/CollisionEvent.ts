import type { Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import type { ColliderPart } from './PhysicsParts';

/**
 * Argument of a component's `onCollisionEnter(event)` and `onCollisionExit(event)`; where one of the two colliders is a
 * sensor, of `onTriggerEnter(event)` and `onTriggerExit(event)`. They are called on the components of the object with
 * the collider, and of the object with the RigidBody that the collider belongs to.
 */
export interface CollisionEvent {
  readonly type: 'enter' | 'exit';
  /** The touched object: the one with the RigidBody, or the Collider's own object without one. */
  readonly other: GameObject;
  /** The object whose components are called. */
  readonly object: GameObject;
  /** Collider on the side of `object`; null for a CharacterController's capsule. */
  readonly collider: ColliderPart | null;
  /** Collider on the side of `other`; null for a CharacterController's capsule. */
  readonly otherCollider: ColliderPart | null;
  /** Whether one of the two colliders is a sensor, which blocks no movement. */
  readonly isSensor: boolean;
  /** Contact point in world space (m); null for sensors and at the exit. */
  readonly point: Vector3 | null;
  /** World-space unit normal from `other` to `object`; null for sensors and at the exit. */
  readonly normal: Vector3 | null;
  /** Impulse of the first contact (N·s); 0 for sensors and at the exit. */
  readonly impulse: number;
}

/** Names of component methods for collision events. */
export const collisionMethods = ['onCollisionEnter', 'onCollisionExit', 'onTriggerEnter', 'onTriggerExit'] as const;
