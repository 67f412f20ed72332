import type { Vector3 } from 'three';

/** Requests of a CharacterController to the physics, and its answers; world space, SI units. */
export interface CharacterControl {
  /** Requested horizontal velocity (world x and z) as a share of full speed; length 1 at most. */
  readonly wish: Vector3;
  isRunning: boolean;
  /** Until the next step: it wants to jump. */
  wantsJump: boolean;
  /** Requested position for an immediate move; null for none. */
  teleport: Vector3 | null;
  /** Written by the physics: of the last step. */
  readonly velocity: Vector3;
  isGrounded: boolean;
}
