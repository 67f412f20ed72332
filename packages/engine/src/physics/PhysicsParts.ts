import type { ValuesOf } from '@farol/editing/fields';
import type { Component } from '../core/Component';
import type { BodyControl } from './BodyControl';
import type { CharacterControl } from './CharacterControl';
import type { characterFields } from './characterFields';
import type { colliderFields } from './colliderFields';
import type { jointFields } from './jointFields';
import type { rigidBodyFields } from './rigidBodyFields';

/** RigidBody as seen by the physics code. */
export interface RigidBodyPart extends Component, ValuesOf<typeof rigidBodyFields> {
  /** Sets the control of the running body. @param control - null when the body is removed */
  setControl(control: BodyControl | null): void;
}

/** Collider as seen by the physics code. */
export interface ColliderPart extends Component, ValuesOf<typeof colliderFields> {}

/** CharacterController as seen by the physics code. */
export interface CharacterPart extends Component, ValuesOf<typeof characterFields> {
  readonly control: CharacterControl;
}

/** Joint as seen by the physics code. */
export interface JointPart extends Component, ValuesOf<typeof jointFields> {}
