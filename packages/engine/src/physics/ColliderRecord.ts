import { shortText } from '@farol/editing';
import type { Collider as RapierCollider } from '@dimforge/rapier3d-compat';
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import { type Body, type BodyCollider, placeOf } from './Body';
import { collisionMethods } from './CollisionEvent';
import { colliderShape } from './colliderShape';
import type { Rapier } from './loadRapier';
import { makeColliderDesc } from './makeColliderDesc';
import { ObjectWatch } from './ObjectWatch';
import type { CharacterPart, ColliderPart } from './PhysicsParts';

const place = new Vector3();
const turn = new Quaternion();
const one = new Vector3(1, 1, 1);
const size = new Vector3();
const inverse = new Matrix4();

/** A collider of Rapier's world: of a Collider, or of a CharacterController. */
export interface ColliderRecord extends BodyCollider {
  readonly object: GameObject;
  readonly body: Body;
  /** Index among the colliders, by which events are sorted. */
  readonly order: number;
  /**
   * Notices that the collider's object moved relative to its body; null when the collider is on the body's own object.
   */
  readonly watch: ObjectWatch | null;
  /** Matrix from the collider's object to the body at creation; null for a CharacterController's capsule. */
  readonly made: Matrix4 | null;
  /** Matrix from Rapier's shape to the body at creation. */
  readonly shapeMade: Matrix4;
}

const bodyToCollider = new Matrix4();
const columns = [new Vector3(), new Vector3(), new Vector3()] as const;
/** Tolerance per matrix element of a rigid motion. */
const RIGID = 1e-5;

function isRigid(matrix: Matrix4): boolean {
  const [x, y, z] = columns;
  matrix.extractBasis(x, y, z);
  if (!(matrix.determinant() > 0)) return false;
  const skews = [x.dot(y), y.dot(z), z.dot(x), x.lengthSq() - 1, y.lengthSq() - 1, z.lengthSq() - 1];
  return skews.every((skew) => Math.abs(skew) < RIGID);
}

/**
 * Moves a collider to its object's present pose in the body; contacts persist.
 * @returns false when the shape changed too, so that the collider must be rebuilt
 */
export function moveCollider({ object, body, rapier, made, shapeMade }: ColliderRecord): boolean {
  if (!made) return false;
  matrixInBody(object, body, bodyToCollider);
  if (!bodyToCollider.elements.every(Number.isFinite)) return false;
  bodyToCollider.multiply(inverse.copy(made).invert());
  if (!isRigid(bodyToCollider)) return false;
  bodyToCollider.multiply(shapeMade).decompose(place, turn, size);
  rapier.setTranslationWrtParent(place);
  rapier.setRotationWrtParent(turn);
  return true;
}

const nameOf = (object: GameObject): string => `'${shortText(object.name)}'`;

/** Matrix from a collider's object to its body (without scale), by their shown poses. */
export function matrixInBody(object: GameObject, body: Body, target = new Matrix4()): Matrix4 {
  placeOf(body.object.object3D, place, turn);
  inverse.compose(place, turn, one).invert();
  object.object3D.updateWorldMatrix(true, false);
  return target.multiplyMatrices(inverse, object.object3D.matrixWorld);
}

/** Whether any component of an object has a collision method. */
export function listens(object: GameObject): boolean {
  return object.components.some((component) =>
    collisionMethods.some((name) => typeof (component as unknown as Record<string, unknown>)[name] === 'function'),
  );
}

/**
 * Makes the collider of a component.
 * @param make - creates the collider in Rapier's world
 * @throws Error naming the object and the remedy when there is no shape
 */
export function makeCollider(
  rapier: Rapier,
  component: ColliderPart,
  body: Body,
  order: number,
  make: (desc: InstanceType<Rapier['ColliderDesc']>) => RapierCollider,
): ColliderRecord {
  const { gameObject: object } = component;
  const shape = colliderShape(component);
  if (!shape) {
    throw new Error(
      `The Collider of ${nameOf(object)} has no mesh to fit to: give the object a mesh, or switch "Fit to mesh" off and give a size.`,
    );
  }
  if (shape.kind === 'mesh' && body.type === 'dynamic') {
    throw new Error(
      `The Collider of ${nameOf(object)} is a mesh on a dynamic body: choose the convex hull, or make the body fixed or kinematic.`,
    );
  }
  const matrix = matrixInBody(object, body);
  if (!matrix.elements.every(Number.isFinite) || matrix.determinant() === 0) {
    throw new Error(
      `The Collider of ${nameOf(object)} has no size, since its object, or one above it, has a scale of 0: set another.`,
    );
  }
  const desc = makeColliderDesc(rapier, shape, matrix);
  if (!desc) {
    throw new Error(
      `The Collider of ${nameOf(object)} gets no ${shape.kind} from its mesh, which has too few points or wrong ones: choose a box.`,
    );
  }
  const { ActiveCollisionTypes: Types, ActiveEvents, CoefficientCombineRule } = rapier;
  const heard = listens(object) || listens(body.object);
  desc
    .setSensor(component.sensor)
    .setFriction(component.friction)
    .setRestitution(component.restitution)
    .setRestitutionCombineRule(CoefficientCombineRule.Max)
    .setDensity(component.sensor ? 0 : component.density)
    .setActiveEvents(heard ? ActiveEvents.COLLISION_EVENTS : ActiveEvents.NONE);
  if (component.sensor) {
    desc.setActiveCollisionTypes(Types.DEFAULT | Types.KINEMATIC_FIXED | Types.KINEMATIC_KINEMATIC);
  }
  const made = make(desc);
  return {
    component,
    object,
    body,
    rapier: made,
    order,
    watch: object === body.object ? null : new ObjectWatch(object.object3D, body.object.object3D),
    weight: component.sensor ? 0 : made.volume() * component.density,
    made: matrix,
    shapeMade: poseOf(desc),
  };
}

function poseOf({ translation, rotation }: InstanceType<Rapier['ColliderDesc']>): Matrix4 {
  const { x, y, z, w } = rotation;
  return new Matrix4().compose(
    new Vector3(translation.x, translation.y, translation.z),
    new Quaternion(x, y, z, w),
    new Vector3(1, 1, 1),
  );
}

export function makeCapsule(
  { ColliderDesc: Desc, ActiveEvents }: Rapier,
  component: CharacterPart,
  body: Body,
  order: number,
  make: (desc: InstanceType<Rapier['ColliderDesc']>) => RapierCollider,
): ColliderRecord {
  const { gameObject: object } = component;
  matrixInBody(object, body, inverse).decompose(place, turn, one);
  const [across, along] = [Math.max(Math.abs(one.x), Math.abs(one.z)), Math.abs(one.y)];
  place.set(...component.centre).applyMatrix4(inverse);
  one.set(1, 1, 1);
  const radius = component.radius * across;
  if (!(radius > 0) || along === 0) {
    throw new Error(
      `The CharacterController of ${nameOf(object)} has no size, since its object, or one above it, has a scale of 0: set another.`,
    );
  }
  const half = Math.max((component.height * along) / 2 - radius, 0.001);
  const desc = Desc.capsule(half, radius).setTranslation(place.x, place.y, place.z);
  // Rapier reports only sensors; other contacts are the controller's to report, as it keeps a distance
  desc.setActiveEvents(listens(object) ? ActiveEvents.COLLISION_EVENTS : ActiveEvents.NONE);
  return {
    component: null,
    object,
    body,
    rapier: make(desc),
    order,
    watch: null,
    weight: 0,
    made: null,
    shapeMade: poseOf(desc),
  };
}
