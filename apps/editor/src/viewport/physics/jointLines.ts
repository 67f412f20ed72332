import type { CharacterController, Joint } from '@farol/engine';
import { Quaternion, Vector3 } from 'three';
import type { LineSet } from '../LineSet';
import { drawShape } from './colliderLines';

const from = new Vector3();
const to = new Vector3();
const u = new Vector3();
const v = new Vector3();
const axis = new Vector3();

/** Radius of a hinge's circle (m); a joint's other lines are fractions or multiples of it. */
const SIZE = 0.25;

/** World position of a joint's anchor. */
export function anchorOf(joint: Joint, target: Vector3): Vector3 {
  const { object3D } = joint.gameObject;
  object3D.updateWorldMatrix(true, false);
  return target.fromArray(joint.anchor).applyMatrix4(object3D.matrixWorld);
}

/** World position of a joint's anchor on its partner; null when it is not set, and follows from the joint's anchor. */
export function partnerAnchorOf(joint: Joint, target: Vector3): Vector3 | null {
  if (!joint.ownPartnerAnchor) return null;
  target.fromArray(joint.partnerAnchor);
  const partner = joint.partner === null ? null : joint.scene?.findById(joint.partner);
  if (!partner) return target;
  partner.object3D.updateWorldMatrix(true, false);
  return target.applyMatrix4(partner.object3D.matrixWorld);
}

/** A cross at the joint, a line to its partner, the axis of hinges and sliders, and a circle around a hinge. */
export function drawJoint(lines: LineSet, joint: Joint): void {
  const place = anchorOf(joint, new Vector3());
  for (let i = 0; i < 3; i++) {
    lines.line(
      from.copy(place).setComponent(i, place.getComponent(i) - SIZE / 3),
      to.copy(place).setComponent(i, place.getComponent(i) + SIZE / 3),
    );
  }
  const far = partnerAnchorOf(joint, to);
  if (far) lines.line(place, far);
  const partner = joint.partner === null ? null : joint.scene?.findById(joint.partner);
  if (partner) lines.line(far?.clone() ?? place, from.setFromMatrixPosition(partner.object3D.matrixWorld));
  if (joint.type !== 'hinge' && joint.type !== 'slider') return;
  axis.fromArray(joint.axis).transformDirection(joint.gameObject.object3D.matrixWorld);
  if (axis.lengthSq() === 0) return;
  lines.line(from.copy(place).addScaledVector(axis, -SIZE * 2), to.copy(place).addScaledVector(axis, SIZE * 2));
  if (joint.type === 'slider') return;
  u.set(Math.abs(axis.x) < 0.9 ? 1 : 0, Math.abs(axis.x) < 0.9 ? 0 : 1, 0)
    .cross(axis)
    .setLength(SIZE);
  v.crossVectors(axis, u);
  lines.circle(place, u, v, 32);
}

export function drawCharacter(lines: LineSet, { gameObject, height, radius, centre }: CharacterController): void {
  const { object3D } = gameObject;
  object3D.updateWorldMatrix(true, false);
  const [place, rotation, scale] = [new Vector3(), new Quaternion(), new Vector3()];
  object3D.matrixWorld.decompose(place, rotation, scale);
  place.fromArray(centre).applyMatrix4(object3D.matrixWorld);
  const across = radius * Math.max(Math.abs(scale.x), Math.abs(scale.z));
  const half = new Vector3(across, Math.max((height * Math.abs(scale.y)) / 2, across), across);
  drawShape(lines, 'capsule', 1, { centre: place, rotation, half, scale });
}
