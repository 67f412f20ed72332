import type { Vector3 } from 'three';

/** Requests of a CharacterController to the physics, and its answers; world space, SI units. */
export interface CharacterControl {
  /** Requested horizontal velocity (world x and z) as a share of full speed; length 1 at most. */
  readonly wish: Vector3;
  isRunning: boolean;
  /** Whether to jump in the next step, which resets the flag. */
  wantsJump: boolean;
  /** Requested position for an immediate move; null for none. */
  teleport: Vector3 | null;
  /** Velocity in the last step (m/s), written by the physics. */
  readonly velocity: Vector3;
  isGrounded: boolean;
}
