import type { Quaternion, Vector3 } from 'three';

/** Control of a body in the running simulation; world space, SI units. */
export interface BodyControl {
  readonly isSleeping: boolean;
  /** Mass of the body (kg). */
  readonly mass: number;
  velocity(target: Vector3): Vector3;
  setVelocity(velocity: Vector3): void;
  angularVelocity(target: Vector3): Vector3;
  setAngularVelocity(velocity: Vector3): void;
  /** @param point - point of application; the centre of mass when null */
  applyImpulse(impulse: Vector3, point: Vector3 | null): void;
  /**
   * Applies a force (N) for the duration of the frame.
   * @param point - point of application; the centre of mass when null
   */
  applyForce(force: Vector3, point: Vector3 | null): void;
  applyTorque(torque: Vector3): void;
  wakeUp(): void;
  /** @param rotation - unchanged when null */
  teleport(position: Vector3, rotation: Quaternion | null): void;
}
