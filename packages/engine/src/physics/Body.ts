import type { Collider as RapierCollider, RigidBody as RapierBody } from '@dimforge/rapier3d-compat';
import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import type { BodyControl } from './BodyControl';
import { ObjectWatch } from './ObjectWatch';
import type { CharacterPart, ColliderPart, RigidBodyPart } from './PhysicsParts';
import { mirrored, worldRotation } from './worldRotation';

export type BodyType = 'dynamic' | 'kinematic' | 'fixed' | 'character';

const position = new Vector3();
const rotation = new Quaternion();
/** Targets that Rapier writes to: plain numbers, without the listeners of a Quaternion. */
const place = { x: 0, y: 0, z: 0 };
const turn = { x: 0, y: 0, z: 0, w: 1 };
/** Position and quaternion interpolated between two steps. */
const between = [0, 0, 0, 0, 0, 0, 1];

/**
 * Offsets in a body's `state`: world position and quaternion before the last step, then after it, then the local
 * position, quaternion and scale last written to the object.
 */
const NOW = 7;
const SHOWN = 14;
const SHOWN_SCALE = 21;
const LENGTH = 24;
const parentRotation = new Quaternion();
const signs = new Vector3();
const arm = new Vector3();
const previousPosition = new Vector3();
const inverse = new Matrix4();

/** Writes an object's world position and rotation to `target` and `turned`. */
export function placeOf(object: Object3D, target: Vector3, turned: Quaternion): void {
  object.updateWorldMatrix(true, false);
  target.setFromMatrixPosition(object.matrixWorld);
  worldRotation(object, turned, signs).normalize();
}

/** Part of a collider's record that Body uses. */
export interface BodyCollider {
  /** Null for the capsule of a CharacterController. */
  readonly component: ColliderPart | null;
  readonly rapier: RapierCollider;
  /** Volume times density (m³ × density): the collider's share of the body's mass. */
  readonly weight: number;
}

/**
 * A body of Rapier's world and its object, in world space. For a dynamic body, the last two steps are kept, and the
 * object is shown between them.
 */
export class Body implements BodyControl {
  /** Index among the bodies, by which events are sorted. */
  order = 0;
  hasTarget = false;
  /** Colliders of the body, in order of creation. */
  readonly colliders = new Set<BodyCollider>();
  /** Force (N) and torque (N·m) that act during this frame; null for none. */
  force: Vector3 | null = null;
  torque: Vector3 | null = null;

  /** Poses of the body, in one array since each step reads and writes them for every body. */
  private readonly state = new Float64Array(LENGTH);
  /** Pose of a kinematic body after this frame's steps. */
  private readonly target = new Vector3();
  private readonly turnTarget = new Quaternion();
  private watch: ObjectWatch;
  /** Whether the body slept after the last step. */
  private wasSleeping = false;
  /** Whether the body sleeps and its object shows the final pose. */
  private isSettled = false;

  constructor(
    readonly object: GameObject,
    /** Null for colliders without a RigidBody. */
    readonly component: RigidBodyPart | CharacterPart | null,
    public type: BodyType,
    readonly rapier: RapierBody,
  ) {
    this.watch = new ObjectWatch(object.object3D);
    placeOf(object.object3D, position, rotation);
    this.setNow(position, rotation);
    this.stay();
    this.noteShown();
  }

  get isSleeping(): boolean {
    return this.rapier.isSleeping();
  }

  get mass(): number {
    return this.rapier.mass();
  }

  velocity(target: Vector3): Vector3 {
    return this.rapier.linvel(target) as Vector3;
  }

  setVelocity(velocity: Vector3): void {
    this.rapier.setLinvel(velocity, true);
  }

  angularVelocity(target: Vector3): Vector3 {
    return this.rapier.angvel(target) as Vector3;
  }

  setAngularVelocity(velocity: Vector3): void {
    this.rapier.setAngvel(velocity, true);
  }

  applyImpulse(impulse: Vector3, point: Vector3 | null): void {
    if (point) this.rapier.applyImpulseAtPoint(impulse, point, true);
    else this.rapier.applyImpulse(impulse, true);
  }

  applyForce(force: Vector3, point: Vector3 | null): void {
    (this.force ??= new Vector3()).add(force);
    if (!point) return;
    const arm = point.clone().sub(this.rapier.worldCom());
    this.applyTorque(arm.cross(force));
  }

  applyTorque(torque: Vector3): void {
    (this.torque ??= new Vector3()).add(torque);
  }

  wakeUp(): void {
    this.rapier.wakeUp();
  }

  teleport(to: Vector3, turned: Quaternion | null): void {
    this.putAt(to, turned ?? rotation.fromArray(this.state, NOW + 3));
    this.show(1);
  }

  /** Converts the frame's force and torque into impulses of a step of this length. */
  spendForces(deltaSeconds: number): void {
    if (this.force) this.rapier.applyImpulse(this.force.multiplyScalar(deltaSeconds), true);
    if (this.torque) this.rapier.applyTorqueImpulse(this.torque.multiplyScalar(deltaSeconds), true);
    this.force = this.torque = null;
  }

  /**
   * Copies the object's pose to the body if the body is not dynamic, or other code has moved the object.
   * @returns whether the object's scale changed, so that its colliders must be rebuilt
   */
  follow(): boolean {
    const { object3D } = this.object;
    if (this.type === 'character') this.followCharacter(object3D);
    else if (this.type === 'dynamic') {
      if (!this.isPositionShown(object3D) || !this.isTurnShown(object3D)) {
        placeOf(object3D, position, rotation);
        this.putAt(position, rotation);
        this.noteShown();
      }
    } else if (this.watch.moved()) {
      if (this.type === 'kinematic') {
        placeOf(object3D, this.target, this.turnTarget);
        this.hasTarget = true;
      } else {
        placeOf(object3D, position, rotation);
        this.putAt(position, rotation);
      }
    }
    const { state } = this;
    const { x, y, z } = object3D.scale;
    if (x === state[SHOWN_SCALE] && y === state[SHOWN_SCALE + 1] && z === state[SHOWN_SCALE + 2]) return false;
    object3D.scale.toArray(state, SHOWN_SCALE);
    return true;
  }

  /** Follows edits of a character's object: rotation is read from it; position is owned by the physics. */
  private followCharacter(object3D: Object3D): void {
    if (!this.isPositionShown(object3D)) {
      placeOf(object3D, position, rotation);
      this.putAt(position, rotation);
      this.noteShown();
    } else if (!this.isTurnShown(object3D)) {
      const { state } = this;
      worldRotation(object3D, rotation, signs).normalize();
      rotation.toArray(state, NOW + 3);
      rotation.toArray(state, 3);
      this.rapier.setNextKinematicRotation(rotation);
      object3D.quaternion.toArray(state, SHOWN + 3);
    }
  }

  /** Moves a kinematic body towards the frame's target. @param share - share of the remaining distance, above 0 to 1 */
  approach(share: number): void {
    const { state } = this;
    this.stay();
    position.fromArray(state, NOW).lerp(this.target, share);
    rotation.fromArray(state, NOW + 3).slerp(this.turnTarget, share);
    this.setNow(position, rotation);
    this.rapier.setNextKinematicTranslation(position);
    this.rapier.setNextKinematicRotation(rotation);
    if (share === 1) this.hasTarget = false;
  }

  /** Holds a kinematic body still in the next step. */
  stay(): void {
    const { state } = this;
    for (let i = 0; i < 7; i++) state[i] = state[NOW + i];
  }

  /** Moves the body by `way` (m) in the next step. */
  advance(way: Vector3): void {
    const { state } = this;
    position.fromArray(state, NOW).add(way).toArray(state, NOW);
    this.rapier.setNextKinematicTranslation(position);
  }

  /**
   * Adds the distance by which the body carried `other` in the last step.
   * @param other - body on top of this one
   * @param way - receives the added displacement (m, world space)
   */
  carry(other: Body, way: Vector3): void {
    if (!this.movedInStep) return;
    const { state } = this;
    position.fromArray(other.state, NOW);
    arm.copy(position).sub(previousPosition.fromArray(state));
    rotation
      .fromArray(state, 3)
      .invert()
      .premultiply(parentRotation.fromArray(state, NOW + 3));
    arm.applyQuaternion(rotation).add(previousPosition.fromArray(state, NOW)).sub(position);
    way.add(arm);
  }

  /** Reads a dynamic body's pose after a step. */
  read(): void {
    const { rapier, state } = this;
    this.wasSleeping = rapier.isSleeping();
    if (this.wasSleeping && this.isSettled) return;
    this.isSettled = false;
    this.stay();
    rapier.translation(place);
    state[NOW] = place.x;
    state[NOW + 1] = place.y;
    state[NOW + 2] = place.z;
    rapier.rotation(turn);
    const { x, y, z, w } = turn;
    const factor = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
    state[NOW + 3] = x * factor;
    state[NOW + 4] = y * factor;
    state[NOW + 5] = z * factor;
    state[NOW + 6] = w * factor;
  }

  /** Shows the object between the last two steps. @param share - 0 is the earlier step, 1 the last */
  show(share: number): void {
    const { object3D } = this.object;
    const { parent } = object3D;
    const isTop = !parent?.parent;
    if (this.isSettled && isTop) return;
    const { state } = this;
    let from: ArrayLike<number> = state;
    if (share > 0) {
      from = between;
      for (let i = 0; i < 3; i++) between[i] = state[i] + (state[NOW + i] - state[i]) * share;
      const numbers = state as unknown as number[];
      Quaternion.slerpFlat(between, 3, numbers, 3, numbers, NOW + 3, share);
    }
    if (parent && !isTop) {
      position.set(from[0], from[1], from[2]);
      rotation.set(from[3], from[4], from[5], from[6]);
      from = between;
      parent.updateWorldMatrix(true, false);
      position.applyMatrix4(inverse.copy(parent.matrixWorld).invert());
      worldRotation(parent, parentRotation, signs);
      mirrored(rotation.premultiply(parentRotation.invert()), signs);
      position.toArray(between, 0);
      rotation.toArray(between, 3);
    }
    object3D.position.set(from[0], from[1], from[2]);
    for (let i = 0; i < 3; i++) state[SHOWN + i] = from[i];
    if (this.type === 'character') return;
    let isTurned = false;
    for (let i = 3; i < 7; i++) {
      if (state[SHOWN + i] === from[i]) continue;
      state[SHOWN + i] = from[i];
      isTurned = true;
    }
    // set only if the rotation changed, since three then recomputes the Euler angles
    if (isTurned) object3D.quaternion.set(from[3], from[4], from[5], from[6]);
    this.isSettled = this.wasSleeping && !this.movedInStep;
  }

  /** Makes a new ObjectWatch, for the object's new parent. */
  objectMoved(): void {
    this.watch = new ObjectWatch(this.object.object3D);
    this.noteShown();
  }

  private putAt(to: Vector3, turned: Quaternion): void {
    this.setNow(to, turned);
    this.stay();
    this.hasTarget = false;
    this.isSettled = false;
    this.rapier.setTranslation(to, true);
    this.rapier.setRotation(turned, true);
  }

  private setNow(to: Vector3, turned: Quaternion): void {
    to.toArray(this.state, NOW);
    turned.toArray(this.state, NOW + 3);
  }

  private get movedInStep(): boolean {
    const { state } = this;
    for (let i = 0; i < 7; i++) if (state[i] !== state[NOW + i]) return true;
    return false;
  }

  private isPositionShown({ position: { x, y, z } }: Object3D): boolean {
    const { state } = this;
    return state[SHOWN] === x && state[SHOWN + 1] === y && state[SHOWN + 2] === z;
  }

  private isTurnShown({ quaternion: { x, y, z, w } }: Object3D): boolean {
    const { state } = this;
    return state[SHOWN + 3] === x && state[SHOWN + 4] === y && state[SHOWN + 5] === z && state[SHOWN + 6] === w;
  }

  private noteShown(): void {
    const { position: shown, quaternion, scale } = this.object.object3D;
    shown.toArray(this.state, SHOWN);
    quaternion.toArray(this.state, SHOWN + 3);
    scale.toArray(this.state, SHOWN_SCALE);
  }
}
