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
  /** Place among the colliders, by which events are sorted. */
  readonly order: number;
  /**
   * Notices that the collider's object moved relative to its body; null when the collider is on the body's own object.
   */
  readonly watch: ObjectWatch | null;
  /** From its object to the body when it was made; null for that of a CharacterController. */
  readonly made: Matrix4 | null;
  /** From the shape as Rapier has it to the body, when it was made. */
  readonly shapeMade: Matrix4;
}

const way = new Matrix4();
const columns = [new Vector3(), new Vector3(), new Vector3()] as const;
/** By how much a matrix may differ from one that only moves and turns. */
const RIGID = 1e-5;

function isRigid(matrix: Matrix4): boolean {
  const [x, y, z] = columns;
  matrix.extractBasis(x, y, z);
  if (!(matrix.determinant() > 0)) return false;
  const skews = [x.dot(y), y.dot(z), z.dot(x), x.lengthSq() - 1, y.lengthSq() - 1, z.lengthSq() - 1];
  return skews.every((skew) => Math.abs(skew) < RIGID);
}

/**
 * Moves a collider to where its object is now in the body; what touches it goes on touching it.
 * @returns false where its shape changed too, and it must be made anew
 */
export function moveCollider({ object, body, rapier, made, shapeMade }: ColliderRecord): boolean {
  if (!made) return false;
  matrixInBody(object, body, way);
  if (!way.elements.every(Number.isFinite)) return false;
  way.multiply(inverse.copy(made).invert());
  if (!isRigid(way)) return false;
  way.multiply(shapeMade).decompose(place, turn, size);
  rapier.setTranslationWrtParent(place);
  rapier.setRotationWrtParent(turn);
  return true;
}

const nameOf = (object: GameObject): string => `'${shortText(object.name)}'`;

/** From the object of a collider to its body, which has no scale: as they are shown. */
export function matrixInBody(object: GameObject, body: Body, target = new Matrix4()): Matrix4 {
  placeOf(body.object.object3D, place, turn);
  inverse.compose(place, turn, one).invert();
  object.object3D.updateWorldMatrix(true, false);
  return target.multiplyMatrices(inverse, object.object3D.matrixWorld);
}

/** Whether a component of an object hears of collisions. */
export function listens(object: GameObject): boolean {
  return object.components.some((component) =>
    collisionMethods.some((name) => typeof (component as unknown as Record<string, unknown>)[name] === 'function'),
  );
}

/**
 * Makes the collider of a component.
 * @param make - brings the description into Rapier's world
 * @throws Error naming the object and the mend where there is no shape
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
    throw new Error(`The Collider of ${nameOf(object)} has no size: its object, or one above it, has a scale of 0.`);
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

/** The capsule of a CharacterController. */
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
      `The CharacterController of ${nameOf(object)} has no size: its object, or one above it, has a scale of 0.`,
    );
  }
  const half = Math.max((component.height * along) / 2 - radius, 0.001);
  const desc = Desc.capsule(half, radius).setTranslation(place.x, place.y, place.z);
  // what touches it is told by the controller, which keeps a distance; sensors are told by Rapier
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
