import type { EventQueue, World } from '@dimforge/rapier3d-compat';
import { Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import type { ColliderRecord } from './ColliderRecord';
import type { CollisionEvent, collisionMethods } from './CollisionEvent';

interface Touch {
  readonly a: ColliderRecord;
  readonly b: ColliderRecord;
  readonly started: boolean;
  readonly isSensor: boolean;
  readonly point: Vector3 | null;
  /** Contact normal, from collider b to collider a. */
  readonly normal: Vector3 | null;
  readonly impulse: number;
}

const keyOf = (receiver: GameObject, other: GameObject, isSensor: boolean): string =>
  `${receiver.id} ${other.id} ${isSensor}`;

/** Reports contacts to components: once for each pair of objects, however many colliders they have. */
export class Contacts {
  /** Number of touching collider pairs, by receiving and other object. */
  private readonly counts = new Map<string, number>();
  private touches: Touch[] = [];
  /** Touching collider pairs, whose contacts end when a collider is removed. */
  private readonly open = new Map<string, Touch>();

  constructor(
    private readonly world: World,
    private readonly records: ReadonlyMap<number, ColliderRecord>,
    private readonly call: (
      object: GameObject,
      method: (typeof collisionMethods)[number],
      event: CollisionEvent,
    ) => void,
  ) {}

  /** Collects the contacts that began and ended in a step. */
  collect(queue: EventQueue): void {
    const first = this.touches.length;
    queue.drainCollisionEvents((handle1, handle2, started) => {
      const one = this.records.get(handle1);
      const two = this.records.get(handle2);
      if (!one || !two || one.body === two.body) return;
      const [a, b] = one.order < two.order ? [one, two] : [two, one];
      const key = `${a.order} ${b.order}`;
      const isSensor = a.rapier.isSensor() || b.rapier.isSensor();
      const touch: Touch = { a, b, started, isSensor, ...(started && !isSensor ? this.contactOf(a, b) : none) };
      if (started ? this.open.has(key) : !this.open.delete(key)) return;
      if (started) this.open.set(key, touch);
      this.touches.push(touch);
    });
    if (this.touches.length - first < 2) return;
    const sorted = this.touches.slice(first).sort(inOrder);
    this.touches.splice(first, sorted.length, ...sorted);
  }

  /** Adds a contact of a character, which Rapier does not report. @param normal - from `two` to `one` */
  touch(
    one: ColliderRecord,
    two: ColliderRecord,
    started: boolean,
    point: Vector3 | null,
    normal: Vector3 | null,
  ): void {
    const [a, b] = one.order < two.order ? [one, two] : [two, one];
    const key = `${a.order} ${b.order}`;
    if (started ? this.open.has(key) : !this.open.delete(key)) return;
    if (a !== one) normal?.negate();
    const touch: Touch = { a, b, started, isSensor: false, point, normal, impulse: 0 };
    if (started) this.open.set(key, touch);
    this.touches.push(touch);
  }

  end(record: ColliderRecord): void {
    for (const [key, { a, b, isSensor }] of this.open) {
      if (a !== record && b !== record) continue;
      this.open.delete(key);
      this.touches.push({ a, b, started: false, isSensor, ...none });
    }
  }

  /** Calls the collision methods, in the order of the steps and of the tree. */
  tell(): void {
    if (this.touches.length === 0) return;
    const { touches } = this;
    this.touches = [];
    for (const touch of touches) {
      this.tellSide(touch, touch.a, touch.b, 1);
      this.tellSide(touch, touch.b, touch.a, -1);
    }
  }

  private tellSide(touch: Touch, own: ColliderRecord, other: ColliderRecord, sense: 1 | -1): void {
    this.tellObject(own.object, touch, own, other, sense);
    if (own.body.object !== own.object) this.tellObject(own.body.object, touch, own, other, sense);
  }

  private tellObject(
    object: GameObject,
    touch: Touch,
    own: ColliderRecord,
    other: ColliderRecord,
    sense: 1 | -1,
  ): void {
    const { isSensor, started } = touch;
    const key = keyOf(object, other.body.object, isSensor);
    const before = this.counts.get(key) ?? 0;
    const after = before + (started ? 1 : -1);
    if (after > 0) this.counts.set(key, after);
    else this.counts.delete(key);
    if (started ? before > 0 : after > 0) return;
    const kind = isSensor ? 'Trigger' : 'Collision';
    this.call(object, `on${kind}${started ? 'Enter' : 'Exit'}`, {
      type: started ? 'enter' : 'exit',
      object,
      other: other.body.object,
      collider: own.component,
      otherCollider: other.component,
      isSensor,
      point: touch.point?.clone() ?? null,
      normal: touch.normal?.clone().multiplyScalar(sense) ?? null,
      impulse: touch.impulse,
    });
  }

  private contactOf(a: ColliderRecord, b: ColliderRecord): Pick<Touch, 'point' | 'normal' | 'impulse'> {
    const found = { point: new Vector3(), normal: new Vector3(), impulse: 0 };
    let isFound = false;
    this.world.contactPair(a.rapier, b.rapier, (manifold, flipped) => {
      for (let i = 0; i < manifold.numContacts(); i++) found.impulse += manifold.contactImpulse(i);
      if (isFound || manifold.numSolverContacts() === 0) return;
      isFound = true;
      manifold.solverContactPoint(0, found.point);
      // Rapier's normal goes from its first collider to its second
      manifold.normal(found.normal);
      if (!flipped) found.normal.negate();
    });
    return isFound ? found : { ...none, impulse: found.impulse };
  }
}

const none = { point: null, normal: null, impulse: 0 };

/** Sort order: ends before beginnings, then by the colliders' places in the tree. */
const inOrder = (one: Touch, two: Touch): number =>
  Number(one.started) - Number(two.started) || one.a.order - two.a.order || one.b.order - two.b.order;
