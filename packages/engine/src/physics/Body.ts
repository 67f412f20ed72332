import type { RigidBody as RapierBody } from '@dimforge/rapier3d-compat';
import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import type { GameObject } from '../core/SceneGraph';
import type { BodyControl } from './BodyControl';
import { ObjectWatch } from './ObjectWatch';
import type { CharacterPart, RigidBodyPart } from './PhysicsParts';
import { mirrored, worldRotation } from './worldRotation';

export type BodyType = 'dynamic' | 'kinematic' | 'fixed' | 'character';

const position = new Vector3();
const rotation = new Quaternion();
const parentRotation = new Quaternion();
const signs = new Vector3();
const scale = new Vector3();
const inverse = new Matrix4();

/** Where an object is in the world, without its scale. */
export function placeOf(object: Object3D, place: Vector3, turn: Quaternion): void {
  object.updateWorldMatrix(true, false);
  place.setFromMatrixPosition(object.matrixWorld);
  worldRotation(object, turn, signs).normalize();
}

/**
 * A body of Rapier's world and the object that it is of. Places are of the world; of a dynamic body the last two steps
 * are kept, and the object is shown between them.
 */
export class Body implements BodyControl {
  /** Where it was before the last step. */
  readonly before = new Vector3();
  readonly turnBefore = new Quaternion();
  /** Where it is after the last step. */
  readonly now = new Vector3();
  readonly turnNow = new Quaternion();
  /** Where a kinematic body shall be after the steps of this frame. */
  readonly target = new Vector3();
  readonly turnTarget = new Quaternion();
  /** Place among the bodies, by which events are sorted. */
  order = 0;
  hasTarget = false;
  /** What acts during this frame (N, N·m); null for nothing. */
  force: Vector3 | null = null;
  torque: Vector3 | null = null;

  private watch: ObjectWatch;
  /** What was last shown, to notice that somebody else moved the object. */
  private readonly shownPosition = new Vector3();
  private readonly shownTurn = new Quaternion();
  private readonly shownScale = new Vector3();
  /** As of the last step. */
  private wasSleeping = false;
  /** It rests where it is shown. */
  private isSettled = false;

  constructor(
    readonly object: GameObject,
    /** Null for colliders without a RigidBody. */
    readonly component: RigidBodyPart | CharacterPart | null,
    public type: BodyType,
    readonly rapier: RapierBody,
  ) {
    this.watch = new ObjectWatch(object.object3D);
    placeOf(object.object3D, this.now, this.turnNow);
    this.before.copy(this.now);
    this.turnBefore.copy(this.turnNow);
    this.noteShown();
  }

  /** The matrix from the body's space, which has no scale, to the world: as of now. */
  matrix(target: Matrix4): Matrix4 {
    return target.compose(this.now, this.turnNow, scale.set(1, 1, 1));
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

  teleport(place: Vector3, turn: Quaternion | null): void {
    this.putAt(place, turn ?? this.turnNow);
    this.show(1);
  }

  /** Turns forces of the frame into an impulse. */
  spendForces(deltaSeconds: number): void {
    if (this.force) this.rapier.applyImpulse(this.force.multiplyScalar(deltaSeconds), true);
    if (this.torque) this.rapier.applyTorqueImpulse(this.torque.multiplyScalar(deltaSeconds), true);
    this.force = this.torque = null;
  }

  /**
   * Follows its object: what is not dynamic, or was moved by somebody else than the physics.
   * @returns whether the size of the object changed, and its colliders with it
   */
  follow(): boolean {
    const { object3D } = this.object;
    if (this.type === 'character') this.followCharacter(object3D);
    else if (this.type === 'dynamic') {
      if (!this.isShownAsWas(object3D)) {
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
    const { scale: size } = object3D;
    if (this.shownScale.equals(size)) return false;
    this.shownScale.copy(size);
    return true;
  }

  /** Where a character stands is the physics', whither it looks its own. */
  private followCharacter(object3D: Object3D): void {
    if (!this.shownPosition.equals(object3D.position)) {
      placeOf(object3D, position, rotation);
      this.putAt(position, rotation);
      this.noteShown();
    } else if (!this.shownTurn.equals(object3D.quaternion)) {
      worldRotation(object3D, this.turnNow, signs).normalize();
      this.turnBefore.copy(this.turnNow);
      this.rapier.setNextKinematicRotation(this.turnNow);
      this.shownTurn.copy(object3D.quaternion);
    }
  }

  /** Moves a kinematic body on its way through the frame. @param share - of the way that is left, above 0 to 1 */
  approach(share: number): void {
    this.before.copy(this.now);
    this.turnBefore.copy(this.turnNow);
    this.now.lerp(this.target, share);
    this.turnNow.slerp(this.turnTarget, share);
    this.rapier.setNextKinematicTranslation(this.now);
    this.rapier.setNextKinematicRotation(this.turnNow);
    if (share === 1) this.hasTarget = false;
  }

  /** A kinematic body that does not move in a step. */
  stay(): void {
    this.before.copy(this.now);
    this.turnBefore.copy(this.turnNow);
  }

  /** Takes over where a step put a dynamic body. */
  read(): void {
    this.wasSleeping = this.rapier.isSleeping();
    if (this.wasSleeping && this.isSettled) return;
    this.isSettled = false;
    this.before.copy(this.now);
    this.turnBefore.copy(this.turnNow);
    this.rapier.translation(this.now);
    this.rapier.rotation(this.turnNow);
    this.turnNow.normalize();
  }

  /** Moves the object to between the last two steps. @param share - 0 is the one before, 1 the last */
  show(share: number): void {
    const { object3D } = this.object;
    const { parent } = object3D;
    const isTop = !parent?.parent;
    if (this.isSettled && isTop) return;
    if (share > 0) {
      position.lerpVectors(this.before, this.now, share);
      rotation.slerpQuaternions(this.turnBefore, this.turnNow, share);
    } else {
      position.copy(this.before);
      rotation.copy(this.turnBefore);
    }
    if (parent && !isTop) {
      parent.updateWorldMatrix(true, false);
      position.applyMatrix4(inverse.copy(parent.matrixWorld).invert());
      worldRotation(parent, parentRotation, signs);
      mirrored(rotation.premultiply(parentRotation.invert()), signs);
    }
    object3D.position.copy(position);
    this.shownPosition.copy(position);
    if (this.type === 'character') return;
    // three computes angles anew with each rotation
    if (!this.shownTurn.equals(rotation)) {
      object3D.quaternion.copy(rotation);
      this.shownTurn.copy(rotation);
    }
    this.isSettled = this.wasSleeping && this.before.equals(this.now) && this.turnBefore.equals(this.turnNow);
  }

  /** The object belongs elsewhere in the tree. */
  objectMoved(): void {
    this.watch = new ObjectWatch(this.object.object3D);
    this.noteShown();
  }

  private putAt(place: Vector3, turn: Quaternion): void {
    this.now.copy(place);
    this.turnNow.copy(turn);
    this.before.copy(place);
    this.turnBefore.copy(this.turnNow);
    this.hasTarget = false;
    this.isSettled = false;
    this.rapier.setTranslation(this.now, true);
    this.rapier.setRotation(this.turnNow, true);
  }

  private isShownAsWas({ position: place, quaternion }: Object3D): boolean {
    return this.shownPosition.equals(place) && this.shownTurn.equals(quaternion);
  }

  private noteShown(): void {
    const { position: place, quaternion, scale: size } = this.object.object3D;
    this.shownPosition.copy(place);
    this.shownTurn.copy(quaternion);
    this.shownScale.copy(size);
  }
}
