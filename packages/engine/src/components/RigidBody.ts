import { type Quaternion, Vector3 } from 'three';
import { toVector3, type Vector3Input } from '../core/toVector3';
import type { BodyControl } from '../physics/BodyControl';
import { rigidBodyFields } from '../physics/rigidBodyFields';
import { physicsComponent } from '../physics/physicsComponent';

/**
 * Makes an object a body of the scene's physics, with the Colliders of the object and of those below it. While the
 * scene plays a dynamic body is moved by forces and collisions; a kinematic one follows its object, which animation or
 * scripts move, and pushes others; a fixed one stays. Its motion is simulation: it is not saved, and `scene.reset()`
 * undoes it. Its methods may be called from `start` on; calls made before the physics has started are deferred.
 */
export class RigidBody extends physicsComponent(rigidBodyFields) {
  static override readonly typeName: string = 'RigidBody';
  static override readonly icon: string = 'body';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A body that falls, is pushed, or pushes others.';
  static override readonly callable: readonly string[] = [
    'applyImpulse',
    'applyForce',
    'applyTorque',
    'teleport',
    'wakeUp',
  ];

  private control: BodyControl | null = null;
  /** Calls made before the physics has created the body; run once it has. */
  private readonly waiting: ((body: BodyControl) => void)[] = [];

  /** @internal Called by the physics. @param control - null when the body is removed */
  setControl(control: BodyControl | null): void {
    this.control = control;
    if (control) for (const call of this.waiting.splice(0)) call(control);
  }

  /** Velocity in the world (m/s): a copy. Setting wakes the body. */
  get velocity(): Vector3 {
    return this.control ? this.control.velocity(new Vector3()) : new Vector3(...this.initialVelocity);
  }

  set velocity(value: Vector3Input) {
    const velocity = toVector3(value, new Vector3());
    this.whenThere((body) => body.setVelocity(velocity));
  }

  /** Angular velocity (rad/s) as a vector along the world axis: a copy. Setting wakes the body. */
  get angularVelocity(): Vector3 {
    return this.control ? this.control.angularVelocity(new Vector3()) : new Vector3(...this.initialAngularVelocity);
  }

  set angularVelocity(value: Vector3Input) {
    const velocity = toVector3(value, new Vector3());
    this.whenThere((body) => body.setAngularVelocity(velocity));
  }

  /** Whether the body sleeps, at no cost, until it is touched. */
  get isSleeping(): boolean {
    return this.control?.isSleeping ?? false;
  }

  /**
   * Changes the velocity of a dynamic body at once.
   * @param impulse - in the world (N·s)
   * @param point - of the world where it acts (m); the centre of mass when absent
   */
  applyImpulse(impulse: Vector3Input, point?: Vector3Input): void {
    const [value, place] = [toVector3(impulse, new Vector3()), point ? toVector3(point, new Vector3()) : null];
    this.whenThere((body) => body.applyImpulse(value, place));
  }

  /**
   * Applies a force to a dynamic body during this frame; call it in each `update` for a constant force.
   * @param force - in the world (N)
   * @param point - of the world where it acts (m); the centre of mass when absent
   */
  applyForce(force: Vector3Input, point?: Vector3Input): void {
    const [value, place] = [toVector3(force, new Vector3()), point ? toVector3(point, new Vector3()) : null];
    this.whenThere((body) => body.applyForce(value, place));
  }

  /** Turns a dynamic body during this frame. @param torque - in the world (N·m) */
  applyTorque(torque: Vector3Input): void {
    const value = toVector3(torque, new Vector3());
    this.whenThere((body) => body.applyTorque(value));
  }

  /** Wakes a sleeping body. */
  wakeUp(): void {
    this.whenThere((body) => body.wakeUp());
  }

  /**
   * Moves the body at once, without colliding on the way; the velocity stays.
   * @param position - in the world (m)
   * @param rotation - in the world; unchanged when absent
   */
  teleport(position: Vector3Input, rotation?: Quaternion): void {
    const [place, turn] = [toVector3(position, new Vector3()), rotation?.clone() ?? null];
    this.whenThere((body) => body.teleport(place, turn));
  }

  override onDestroy(): void {
    this.waiting.length = 0;
  }

  private whenThere(call: (body: BodyControl) => void): void {
    if (this.control) call(this.control);
    else if (this.scene?.isSimulated) this.waiting.push(call);
  }
}
