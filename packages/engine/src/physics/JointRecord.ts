import { shortText } from '@farol/editing';
import type {
  ImpulseJoint,
  JointData,
  PrismaticImpulseJoint,
  RevoluteImpulseJoint,
  World,
} from '@dimforge/rapier3d-compat';
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import { type Body, placeOf } from './Body';
import type { Rapier } from './loadRapier';
import type { JointPart } from './PhysicsParts';

/** A joint in Rapier's world, and its component. */
export interface JointRecord {
  readonly component: JointPart;
  readonly body: Body;
  /** Second body of the joint; null for a joint to the world. */
  readonly partner: Body | null;
  readonly rapier: ImpulseJoint;
  /** Second joint that limits a ball joint to its cone; null for none. */
  readonly cone: ImpulseJoint | null;
}

const X = new Vector3(1, 0, 0);
const axis = new Vector3();
const place = new Vector3();
const turn = new Quaternion();
const one = new Vector3(1, 1, 1);
const matrix = new Matrix4();

/** A joint's position in a body's space, and the rotation whose X axis is the joint's axis. */
interface LocalFrame {
  readonly anchor: Vector3;
  readonly frame: Quaternion;
}

/** Converts a world point and rotation to a body's space; null is the world itself. */
function localFrame(body: Body | null, point: Vector3, rotation: Quaternion): LocalFrame {
  const [anchor, frame] = [point.clone(), rotation.clone()];
  if (!body) return { anchor, frame };
  placeOf(body.object.object3D, place, turn);
  anchor.applyMatrix4(matrix.compose(place, turn, one).invert());
  return { anchor, frame: frame.premultiply(turn.invert()) };
}

/** Converts a point from an object's space to the world. */
function inWorld(object: GameObject, point: readonly [number, number, number]): Vector3 {
  object.object3D.updateWorldMatrix(true, false);
  return new Vector3(...point).applyMatrix4(object.object3D.matrixWorld);
}

/** World rotation whose X axis is the joint's axis. */
function frameOf(component: JointPart): Quaternion {
  const rotation = new Quaternion();
  placeOf(component.gameObject.object3D, place, rotation);
  axis.set(...component.axis);
  const hasCone = component.type === 'ball' && component.limits;
  if (component.type !== 'hinge' && component.type !== 'slider' && !hasCone) return rotation;
  if (axis.lengthSq() === 0) {
    throw new Error(
      `The Joint of '${shortText(component.gameObject.name)}' has no axis: give it one that is longer than 0.`,
    );
  }
  return rotation.multiply(turn.setFromUnitVectors(X, axis.normalize()));
}

function dataOf({ JointData: Data }: Rapier, component: JointPart, from: Vector3, to: Vector3): JointData {
  const along = { x: 1, y: 0, z: 0 };
  const same = { x: 0, y: 0, z: 0, w: 1 };
  switch (component.type) {
    case 'fixed':
      return Data.fixed(from, same, to, same);
    case 'hinge':
      return Data.revolute(from, to, along);
    case 'ball':
      return Data.spherical(from, to);
    case 'slider':
      return Data.prismatic(from, to, along);
    case 'spring':
      return Data.spring(component.restLength, component.stiffness, component.damping, from, to);
  }
}

/**
 * Makes the joint of a component from the present poses of the two objects.
 * @param partner - null for the world; `ground` then returns a fixed body
 */
export function makeJoint(
  rapier: Rapier,
  world: World,
  component: JointPart,
  body: Body,
  partner: Body | null,
  ground: () => Body['rapier'],
): JointRecord {
  const point = inWorld(component.gameObject, component.anchor);
  const rotation = frameOf(component);
  const own = localFrame(body, point, rotation);
  const other = localFrame(partner, partnerPoint(component, point), rotation);
  const joint = world.createImpulseJoint(
    dataOf(rapier, component, other.anchor, own.anchor),
    partner?.rapier ?? ground(),
    body.rapier,
    true,
  );
  joint.setContactsEnabled(component.collide);
  if (component.type !== 'spring') {
    joint.setLocalFrame1(other.anchor, other.frame);
    joint.setLocalFrame2(own.anchor, own.frame);
  }
  if (component.type === 'hinge' || component.type === 'slider') {
    const unit = joint as RevoluteImpulseJoint | PrismaticImpulseJoint;
    const isHinge = component.type === 'hinge';
    if (component.limits) {
      const lower = isHinge ? component.lowerAngle : component.lowerDistance;
      const upper = isHinge ? component.upperAngle : component.upperDistance;
      unit.setLimits(Math.min(lower, upper), Math.max(lower, upper));
    }
    if (component.motor) {
      unit.configureMotorModel(rapier.MotorModel.ForceBased);
      unit.configureMotorVelocity(isHinge ? component.motorTurn : component.motorSpeed, component.motorStrength);
    }
  }
  let cone: ImpulseJoint | null = null;
  if (component.type === 'ball' && component.limits) {
    cone = world.createImpulseJoint(
      coneOf(rapier, component.coneAngle, other, own, body),
      partner?.rapier ?? ground(),
      body.rapier,
      true,
    );
    cone.setContactsEnabled(component.collide);
  }
  return { component, body, partner, rapier: joint, cone };
}

/** Least distance (m) from a cone limit's anchor to the points that its rope joins. */
const LEVER = 0.05;

/**
 * Limits a ball joint to a cone, which Rapier lacks in JavaScript: a rope joins a point on the axis in one body with
 * the same point in the other, and tightens as the axis tilts. The point is level with the body's centre of mass, where
 * the limit is stiffest.
 */
function coneOf({ JointData: Data }: Rapier, angle: number, from: LocalFrame, to: LocalFrame, body: Body): JointData {
  const { x, y, z } = body.rapier.localCom();
  const way = axis.set(x, y, z).sub(to.anchor).dot(place.copy(X).applyQuaternion(to.frame));
  const lever = Math.abs(way) < LEVER ? LEVER : way;
  const along = ({ anchor, frame }: LocalFrame): Vector3 =>
    X.clone().multiplyScalar(lever).applyQuaternion(frame).add(anchor);
  return Data.rope(2 * Math.abs(lever) * Math.sin(Math.min(angle, Math.PI) / 2), along(from), along(to));
}

function partnerPoint(component: JointPart, point: Vector3): Vector3 {
  if (!component.ownPartnerAnchor) return point;
  const partner = component.partner === null ? null : (component.scene?.findById(component.partner) ?? null);
  return partner ? inWorld(partner, component.partnerAnchor) : new Vector3(...component.partnerAnchor);
}
