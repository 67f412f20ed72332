import { shortText } from '@farol/editing';
import type { EventQueue, World } from '@dimforge/rapier3d-compat';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { SceneChange } from '../core/SceneChange';
import type { Body } from './Body';
import { type ColliderRecord, listens, makeCapsule, makeCollider, moveCollider } from './ColliderRecord';
import { Contacts } from './Contacts';
import type { Rapier } from './loadRapier';
import { CharacterMotion } from './CharacterMotion';
import { applyFields, type BodyPart, makeBody, vectorOf, weigh } from './makeBody';
import { findParts, isCharacter, type SceneParts } from './findParts';
import { type JointRecord, makeJoint } from './JointRecord';
import type { CharacterPart, ColliderPart, JointPart, RigidBodyPart } from './PhysicsParts';

/** Duration of a physics step (s). */
export const STEP = 1 / 60;
/** Greatest number of steps per frame, as in an App's longest frame; further time is dropped. */
const MOST_STEPS = 6;
/** A step runs even if the frame's time falls short by this share of a step, since frame times are not exact. */
const TOLERANCE = 1e-6;

/** Part of PhysicsSystem that PhysicsWorld uses. */
interface Changes {
  readonly revision: number;
  readonly changed: Set<Component>;
  componentChanged(component: Component): void;
}

/**
 * The running physics of a scene: Rapier's world, and a body and colliders for the components of the scene, made in the
 * order of its tree.
 */
export class PhysicsWorld {
  /** Number of physics steps since the world was made. */
  steps = 0;
  readonly times = { rapier: 0, all: 0 };

  private readonly world: World;
  private readonly queue: EventQueue;
  private readonly bodies = new Map<GameObject, Body>();
  /** All bodies, in the order of their creation. */
  private bodyList: Body[] = [];
  private readonly colliders = new Map<ColliderPart, ColliderRecord>();
  /** Colliders whose objects may move relative to their body. */
  private readonly watched = new Set<ColliderRecord>();
  private readonly characters = new Map<Body, CharacterMotion>();
  private readonly joints = new Map<JointPart, JointRecord>();
  /** Fixed Rapier body that joints to the world attach to; null until the first such joint. */
  private ground: Body['rapier'] | null = null;
  private readonly byHandle = new Map<number, ColliderRecord>();
  private readonly contacts: Contacts;
  private readonly reported = new WeakSet<Component>();
  private readonly problems: { component: Component; error: unknown }[] = [];
  private readonly endChanges: () => void;
  private seenRevision = -1;
  private wasEdited = false;
  /** Simulated time since the last step (s). */
  private unsimulated = 0;
  private made = 0;

  constructor(
    private readonly rapier: Rapier,
    private readonly scene: Scene,
    private readonly changes: Changes,
  ) {
    this.world = new rapier.World(vectorOf(scene.settings.gravity));
    this.world.timestep = STEP;
    this.queue = new rapier.EventQueue(true);
    this.contacts = new Contacts(this.world, this.byHandle, (object, method, event) => {
      for (const component of [...object.components]) {
        const listener = (component as unknown as Record<string, unknown>)[method];
        if (typeof listener !== 'function' || !component.isActive || component.scene !== this.scene) continue;
        try {
          listener.call(component, event);
        } catch (error) {
          this.problems.push({ component, error });
        }
      }
    });
    this.endChanges = scene.onChange((change) => this.sceneChanged(change));
  }

  update(deltaSeconds: number): void {
    const began = performance.now();
    this.times.rapier = 0;
    if (this.wasEdited || this.seenRevision !== this.changes.revision) this.reconcile();
    this.follow(deltaSeconds);
    this.unsimulated += deltaSeconds;
    let count = Math.floor(this.unsimulated / STEP + TOLERANCE);
    this.unsimulated = Math.max(0, this.unsimulated - count * STEP);
    count = Math.min(count, MOST_STEPS);
    for (let left = count; left > 0; left--) this.step(left);
    this.show(Math.min(1, this.unsimulated / STEP));
    this.contacts.tell();
    this.times.all = performance.now() - began;
    this.tellProblems();
  }

  dispose(): void {
    this.endChanges();
    for (const body of this.bodyList) controlledBy(body, null);
    for (const motion of this.characters.values()) motion.dispose();
    this.bodies.clear();
    this.bodyList = [];
    this.colliders.clear();
    this.watched.clear();
    this.characters.clear();
    this.joints.clear();
    this.byHandle.clear();
    this.queue.free();
    this.world.free();
  }

  private follow(deltaSeconds: number): void {
    const { bodyList } = this;
    for (let i = 0; i < bodyList.length; i++) {
      const body = bodyList[i];
      if (body.force || body.torque) body.spendForces(deltaSeconds);
      if (body.follow()) this.sizeChanged(body);
    }
    for (const record of this.watched) if (record.watch!.moved()) this.colliderMoved(record);
  }

  /** Moves or rebuilds a collider whose object was moved relative to its body, and wakes the bodies that it touches. */
  private colliderMoved(record: ColliderRecord): void {
    const { body, rapier, component } = record;
    if (!moveCollider(record)) {
      this.changes.componentChanged(component!);
      return;
    }
    if (body.type === 'dynamic') body.rapier.recomputeMassPropertiesFromColliders();
    body.rapier.wakeUp();
    this.world.contactPairsWith(rapier, (other) => other.parent()?.wakeUp());
  }

  /** @param left - remaining steps of this frame, this one included */
  private step(left: number): void {
    const { bodyList } = this;
    for (let i = 0; i < bodyList.length; i++) {
      const body = bodyList[i];
      if (body.hasTarget) body.approach(1 / left);
      else if (body.type === 'kinematic') body.stay();
    }
    for (const motion of this.characters.values()) motion.move(this.steps, STEP);
    const began = performance.now();
    this.stepRapier();
    this.times.rapier += performance.now() - began;
    this.steps++;
    for (let i = 0; i < bodyList.length; i++) if (bodyList[i].type === 'dynamic') bodyList[i].read();
    this.contacts.collect(this.queue);
  }

  /** `World.step` without the walk over all bodies and colliders that Rapier appends for torn soft bodies. */
  private stepRapier(): void {
    const { world } = this;
    world.physicsPipeline.step(
      world.gravity,
      world.integrationParameters,
      world.islands,
      world.broadPhase,
      world.narrowPhase,
      world.bodies,
      world.colliders,
      world.softBodies,
      world.impulseJoints,
      world.multibodyJoints,
      world.ccdSolver,
      this.queue,
    );
  }

  private show(share: number): void {
    const { bodyList } = this;
    for (let i = 0; i < bodyList.length; i++) {
      const { type } = bodyList[i];
      if (type === 'dynamic' || type === 'character') bodyList[i].show(share);
    }
  }

  private sceneChanged(change: SceneChange): void {
    if (change.kind === 'settings') this.world.gravity = vectorOf(this.scene.settings.gravity);
    else if (change.kind === 'field') {
      const { component, field } = change;
      if (field !== 'mesh' && field !== 'model') return;
      for (const collider of component.gameObject.getComponents('Collider')) this.changes.componentChanged(collider);
    } else if (change.kind === 'move') {
      change.gameObject.traverse((object) => this.bodies.get(object)?.objectMoved());
      this.wasEdited = true;
    } else if (change.kind === 'component-add' || change.kind === 'component-remove') this.wasEdited = true;
  }

  /** Creates and removes bodies and colliders to match the scene's components. */
  private reconcile(): void {
    const { changed } = this.changes;
    this.seenRevision = this.changes.revision;
    this.wasEdited = false;
    const parts = findParts(this.scene);
    this.takeAway(parts, changed);
    for (const [object, component] of parts.bodies) this.reconcileBody(object, component, changed);
    const unweighed = new Set<Body>();
    for (const [component, owner] of parts.colliders) {
      const body = this.bodies.get(owner);
      const record = this.colliders.get(component);
      if (record) this.hear(record);
      else if (body) this.attempt(component, () => this.addCollider(component, body));
      if (body && (changed.has(component) || !record)) unweighed.add(body);
    }
    for (const component of changed) {
      const body = component.scene === this.scene ? this.bodies.get(component.gameObject) : undefined;
      if (body) unweighed.add(body);
    }
    for (const body of unweighed) weigh(body);
    for (const [component, owner] of parts.joints) {
      if (!this.joints.has(component)) this.attempt(component, () => this.addJoint(component, owner));
    }
    for (const component of parts.doubled) this.attempt(component, () => refuseDouble(component));
    changed.clear();
    // only now, since calls that were queued for new bodies need the bodies' mass
    for (const body of this.bodyList) controlledBy(body, body);
  }

  private takeAway(parts: SceneParts, changed: ReadonlySet<Component>): void {
    for (const [component, joint] of this.joints) {
      const { body, partner } = joint;
      const isLost = this.isStale(body, parts) || (partner !== null && this.isStale(partner, parts));
      if (parts.joints.get(component) === body.object && !isLost && !changed.has(component)) continue;
      this.joints.delete(component);
      this.world.removeImpulseJoint(joint.rapier, true);
      if (joint.cone) this.world.removeImpulseJoint(joint.cone, true);
    }
    for (const [component, record] of this.colliders) {
      const owner = parts.colliders.get(component);
      if (owner === record.body.object && !changed.has(component) && !this.isStale(record.body, parts)) continue;
      this.removeCollider(record);
    }
    const kept: Body[] = [];
    for (const body of this.bodyList) {
      if (!this.isStale(body, parts)) {
        kept.push(body);
        continue;
      }
      controlledBy(body, null);
      const motion = this.characters.get(body);
      if (motion) {
        this.removeCollider(motion.capsule);
        motion.dispose();
        this.characters.delete(body);
      }
      this.bodies.delete(body.object);
      this.world.removeRigidBody(body.rapier);
    }
    this.bodyList = kept;
  }

  private isStale(body: Body, parts: SceneParts): boolean {
    return !parts.bodies.has(body.object) || parts.bodies.get(body.object) !== body.component;
  }

  private reconcileBody(object: GameObject, component: BodyPart, changed: ReadonlySet<Component>): void {
    const there = this.bodies.get(object);
    if (!there) {
      this.attempt(component ?? object.transform, () => this.addBody(object, component));
    } else if (component && changed.has(component)) {
      if (isCharacter(component)) this.changeCharacter(there, component);
      else applyFields(this.rapier, there, component);
    }
  }

  private addBody(object: GameObject, component: BodyPart): void {
    const body = makeBody(this.rapier, this.world, object, component);
    body.order = this.made++;
    this.bodies.set(object, body);
    this.bodyList.push(body);
    if (!component) return;
    if (isCharacter(component)) this.addCharacter(body, component);
    else applyFields(this.rapier, body, component);
  }

  private addCharacter(body: Body, component: CharacterPart): void {
    const capsule = makeCapsule(this.rapier, component, body, this.made++, (desc) =>
      this.world.createCollider(desc, body.rapier),
    );
    this.byHandle.set(capsule.rapier.handle, capsule);
    const motion = new CharacterMotion(this.rapier, this.world, component, body, capsule, this.byHandle, this.contacts);
    this.characters.set(body, motion);
  }

  private changeCharacter(body: Body, component: CharacterPart): void {
    const before = this.characters.get(body);
    if (before) {
      this.removeCollider(before.capsule);
      before.dispose();
      this.characters.delete(body);
    }
    this.attempt(component, () => this.addCharacter(body, component));
  }

  private addJoint(component: JointPart, owner: GameObject | null): void {
    const { gameObject, partner } = component;
    const name = shortText(gameObject.name);
    const body = owner && this.bodies.get(owner);
    if (!body)
      throw new Error(`The Joint of '${name}' has no body: add a RigidBody to its object, or to one above it.`);
    const other = partner === null ? null : this.scene.findById(partner);
    if (partner !== null && !other) {
      throw new Error(`The partner of the Joint of '${name}' is gone: choose another object, or none for the world.`);
    }
    const otherBody = other && this.bodyAbove(other);
    if (other && (!otherBody || otherBody === body)) {
      const problem = otherBody ? 'is the same body' : 'has no RigidBody';
      throw new Error(
        `The partner of the Joint of '${name}', '${shortText(other.name)}', ${problem}: ${otherBody ? 'choose another object' : 'add one to it'}, or choose none for the world.`,
      );
    }
    const ground = (): Body['rapier'] =>
      (this.ground ??= this.world.createRigidBody(this.rapier.RigidBodyDesc.fixed()));
    this.joints.set(component, makeJoint(this.rapier, this.world, component, body, otherBody, ground));
  }

  private bodyAbove(object: GameObject): Body | null {
    for (let each: GameObject | null = object; each; each = each.parent) {
      const body = this.bodies.get(each);
      if (body) return body;
    }
    return null;
  }

  private addCollider(component: ColliderPart, body: Body): void {
    const record = makeCollider(this.rapier, component, body, this.made++, (desc) =>
      this.world.createCollider(desc, body.rapier),
    );
    this.colliders.set(component, record);
    body.colliders.add(record);
    if (record.watch) this.watched.add(record);
    this.byHandle.set(record.rapier.handle, record);
  }

  private removeCollider(record: ColliderRecord): void {
    this.contacts.end(record);
    this.byHandle.delete(record.rapier.handle);
    this.watched.delete(record);
    if (record.component) this.colliders.delete(record.component);
    record.body.colliders.delete(record);
    this.world.removeCollider(record.rapier, true);
  }

  /** Switches collision events of a collider on if a component has a method for them. */
  private hear({ rapier, object, body }: ColliderRecord): void {
    const { ActiveEvents } = this.rapier;
    const heard = listens(object) || listens(body.object);
    rapier.setActiveEvents(heard ? ActiveEvents.COLLISION_EVENTS : ActiveEvents.NONE);
  }

  private sizeChanged(body: Body): void {
    for (const { component } of body.colliders) if (component) this.changes.componentChanged(component);
    if (body.type === 'character' && body.component) this.changes.componentChanged(body.component);
  }

  private attempt(component: Component, make: () => void): void {
    try {
      make();
    } catch (error) {
      if (this.reported.has(component)) return;
      this.reported.add(component);
      this.problems.push({ component, error });
    }
  }

  private tellProblems(): void {
    for (const { component, error } of this.problems.splice(0)) this.scene.reportError(component, error);
  }
}

const controlledBy = ({ component }: Body, control: Body | null): void => {
  if (component && !isCharacter(component)) component.setControl(control);
};

function refuseDouble(component: RigidBodyPart): never {
  throw new Error(
    `'${shortText(component.gameObject.name)}' has a CharacterController, which is a body of its own: remove the RigidBody.`,
  );
}
