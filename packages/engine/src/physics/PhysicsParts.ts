import type { ValuesOf } from '@farol/editing/fields';
import type { Component } from '../core/Component';
import type { BodyControl } from './BodyControl';
import type { CharacterControl } from './CharacterControl';
import type { characterFields } from './characterFields';
import type { colliderFields } from './colliderFields';
import type { jointFields } from './jointFields';
import type { rigidBodyFields } from './rigidBodyFields';

/** A RigidBody as the physics know it. */
export interface RigidBodyPart extends Component, ValuesOf<typeof rigidBodyFields> {
  /** Takes the body that it is as long as the scene plays. @param control - null when that is given up */
  setControl(control: BodyControl | null): void;
}

/** A Collider as the physics know it. */
export interface ColliderPart extends Component, ValuesOf<typeof colliderFields> {}

/** A CharacterController as the physics know it. */
export interface CharacterPart extends Component, ValuesOf<typeof characterFields> {
  readonly control: CharacterControl;
}

/** A Joint as the physics know it. */
export interface JointPart extends Component, ValuesOf<typeof jointFields> {}
