import type { Vector3 } from 'three';

/** What the controller of a character asks of the physics, and they answer: in the world, SI units. */
export interface CharacterControl {
  /** Where it wants to go, as a share of its full speed: x and z of the world, at most 1 long. */
  readonly wish: Vector3;
  isRunning: boolean;
  /** Until the next step: it wants to jump. */
  wantsJump: boolean;
  /** Where it was asked to be put; null for nowhere. */
  teleport: Vector3 | null;
  /** Written by the physics: of the last step. */
  readonly velocity: Vector3;
  isGrounded: boolean;
}
