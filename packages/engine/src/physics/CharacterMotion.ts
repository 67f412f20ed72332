import type { CharacterCollision, KinematicCharacterController, World } from '@dimforge/rapier3d-compat';
import { Vector3 } from 'three';
import type { Body } from './Body';
import type { ColliderRecord } from './ColliderRecord';
import type { Rapier } from './loadRapier';
import type { CharacterPart } from './PhysicsParts';

/** Distance that the controller keeps from everything (m). */
const SKIN = 0.01;
/** Share of the difference to the requested velocity gained per step on the ground: full speed in 0.2 s. */
const GRIP = 0.25;
/** Number of steps after leaving the ground in which a jump is still accepted. */
const LATE_JUMP = 6;
/** Number of steps without a touch until a contact counts as ended. */
const GRACE = 5;
/** Smallest y of a unit normal that counts as ground. */
const GROUND_NORMAL = 0.3;

const desiredMove = new Vector3();
const moved = new Vector3();

/** Another collider that the character touches. */
interface Hit {
  readonly record: ColliderRecord;
  /** Number of the step of the last touch. */
  step: number;
}

/** Receiver of the character's contacts: `Contacts`. */
interface Touches {
  touch(
    one: ColliderRecord,
    two: ColliderRecord,
    started: boolean,
    point: Vector3 | null,
    normal: Vector3 | null,
  ): void;
}

/** Moves the capsule of a CharacterController through Rapier's world, a step at a time. */
export class CharacterMotion {
  private readonly controller: KinematicCharacterController;
  private readonly hits: Hit[] = [];
  private readonly velocity = new Vector3();
  private readonly accepts;
  private stepsInAir = LATE_JUMP + 1;
  private ground: Body | null = null;
  private readonly collision: CharacterCollision;

  constructor(
    private readonly rapier: Rapier,
    private readonly world: World,
    readonly component: CharacterPart,
    readonly body: Body,
    readonly capsule: ColliderRecord,
    private readonly records: ReadonlyMap<number, ColliderRecord>,
    private readonly contacts: Touches,
  ) {
    this.controller = world.createCharacterController(SKIN);
    this.collision = new rapier.CharacterCollision();
    this.accepts = (collider: { handle: number }): boolean => this.records.get(collider.handle)?.body !== body;
    this.applyFields();
  }

  applyFields(): void {
    const { controller, component } = this;
    controller.setUp({ x: 0, y: 1, z: 0 });
    controller.setMaxSlopeClimbAngle(component.maxSlope);
    controller.setMinSlopeSlideAngle(component.maxSlope);
    if (component.stepHeight > 0) controller.enableAutostep(component.stepHeight, component.radius / 2, true);
    else controller.disableAutostep();
    if (component.snapDistance > 0) controller.enableSnapToGround(component.snapDistance);
    else controller.disableSnapToGround();
    controller.setApplyImpulsesToDynamicBodies(component.pushes);
    controller.setCharacterMass(component.mass);
  }

  /** Runs one step. @param step - number of the step; before the first, surrounding colliders are unknown */
  move(step: number, seconds: number): void {
    const { body, component, controller, velocity, rapier } = this;
    const { control } = component;
    if (control.teleport) {
      body.teleport(control.teleport, null);
      control.teleport = null;
      velocity.set(0, 0, 0);
      this.ground = null;
    }
    body.stay();
    if (step === 0) return;
    this.steer(seconds);
    desiredMove.copy(velocity).multiplyScalar(seconds);
    // adds how far the body below has carried the character
    this.ground?.carry(body, desiredMove);
    controller.computeColliderMovement(
      this.capsule.rapier,
      desiredMove,
      rapier.QueryFilterFlags.EXCLUDE_SENSORS,
      undefined,
      this.accepts,
    );
    controller.computedMovement(moved);
    control.isGrounded = controller.computedGrounded();
    this.stepsInAir = control.isGrounded ? 0 : this.stepsInAir + 1;
    // upward motion was blocked: the head hit something
    if (velocity.y > 0 && moved.y < desiredMove.y / 2) velocity.y = 0;
    this.readHits(step);
    body.advance(moved);
    control.velocity.copy(moved).divideScalar(seconds);
  }

  dispose(): void {
    this.world.removeCharacterController(this.controller);
  }

  private steer(seconds: number): void {
    const { component, velocity } = this;
    const { control } = component;
    const isGrounded = this.stepsInAir === 0;
    const speed = component.walkSpeed * (control.isRunning ? component.runFactor : 1);
    const grip = isGrounded ? GRIP : GRIP * component.airControl;
    velocity.x += (control.wish.x * speed - velocity.x) * grip;
    velocity.z += (control.wish.z * speed - velocity.z) * grip;
    const { y: gravity } = this.world.gravity;
    if (isGrounded && velocity.y < 0) velocity.y = 0;
    if (control.wantsJump && this.stepsInAir <= LATE_JUMP && component.jumpHeight > 0) {
      velocity.y = Math.sqrt(2 * Math.abs(gravity) * component.jumpHeight);
      this.stepsInAir = LATE_JUMP + 1;
      this.ground = null;
    }
    control.wantsJump = false;
    velocity.y += gravity * seconds;
  }

  private readHits(step: number): void {
    const { controller, hits, collision } = this;
    this.ground = null;
    for (let i = 0; i < controller.numComputedCollisions(); i++) {
      const hit = controller.computedCollision(i, collision);
      const record = hit?.collider ? this.records.get(hit.collider.handle) : undefined;
      if (!hit || !record) continue;
      const { normal1, witness1 } = hit;
      if (normal1.y > GROUND_NORMAL && record.body.type === 'kinematic') this.ground = record.body;
      const known = hits.find((each) => each.record === record);
      if (known) known.step = step;
      else {
        hits.push({ record, step });
        const normal = new Vector3(normal1.x, normal1.y, normal1.z);
        this.contacts.touch(this.capsule, record, true, new Vector3(witness1.x, witness1.y, witness1.z), normal);
      }
    }
    for (let i = hits.length - 1; i >= 0; i--) {
      if (step - hits[i].step <= GRACE) continue;
      this.contacts.touch(this.capsule, hits[i].record, false, null, null);
      hits.splice(i, 1);
    }
  }
}
