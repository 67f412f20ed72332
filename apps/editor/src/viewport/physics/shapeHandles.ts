import { type FieldEdit, SetFields, t } from '@farol/editing';
import type { Collider, Joint } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { colliderShape } from '@farol/engine/physics';
import { Matrix4, Plane, Vector3 } from 'three';
import { alongLine, type Handle, roundTo } from '../handles/HandlePoints';
import { frameOf } from './colliderLines';
import { anchorOf, partnerAnchorOf } from './jointLines';

/** Smallest size of a shape (m). */
const SMALLEST = 0.01;

const tupleOf = (vector: Vector3, step = 0.0001): Vector3Tuple =>
  [vector.x, vector.y, vector.z].map((value) => roundTo(value, step)) as unknown as Vector3Tuple;

/**
 * Handles on the sides of a collider's box, sphere, capsule or cylinder. Dragging one ends the automatic fit to the
 * mesh.
 */
export function colliderHandles(collider: Collider): Handle[] {
  const shape = colliderShape(collider);
  if (!shape || shape.kind === 'hull' || shape.kind === 'mesh') return [];
  const { object3D } = collider.gameObject;
  object3D.updateWorldMatrix(true, false);
  const frame = frameOf(shape, object3D.matrixWorld);
  const { centre, half, scale } = frame;
  const sizes = [Math.abs(scale.x), Math.abs(scale.y), Math.abs(scale.z)];
  if (sizes.includes(0)) return [];
  const isRound = (k: number): boolean => shape.kind === 'sphere' || (shape.kind !== 'box' && k !== shape.axis);
  const handles: Handle[] = [];
  for (let k = 0; k < 3; k++) {
    for (const sense of [1, -1]) {
      const direction = new Vector3().setComponent(k, sense).applyQuaternion(frame.rotation);
      const extent = half.getComponent(k);
      handles.push({
        place: centre.clone().addScaledVector(direction, extent),
        drag(ray, step) {
          const reach = alongLine(centre, direction, ray);
          if (reach === null) return null;
          const size = shape.half.clone().multiplyScalar(2);
          const offset = shape.centre.clone();
          if (isRound(k)) {
            const radius = Math.max(roundTo(reach, step), SMALLEST);
            for (let i = 0; i < 3; i++) if (isRound(i)) size.setComponent(i, (2 * radius) / sizes[i]);
          } else {
            // the opposite side stays in place
            const whole = Math.max(roundTo(reach + extent, step), SMALLEST);
            size.setComponent(k, whole / sizes[k]);
            offset.setComponent(k, offset.getComponent(k) + (sense * (whole - 2 * extent)) / 2 / scale.getComponent(k));
          }
          const values = { fit: false, size: tupleOf(size), offset: tupleOf(offset) };
          const edits = Object.entries(values).map(([name, value]): FieldEdit => ({ owner: collider, name, value }));
          return new SetFields(t('Sized the collider of {name}', { name: collider.gameObject.name }), edits);
        },
      });
    }
  }
  return handles;
}

/** Handles that move the anchors of a joint, parallel to the view plane. */
export function jointHandles(joint: Joint): Handle[] {
  const anchor = anchorOf(joint, new Vector3());
  const far = partnerAnchorOf(joint, new Vector3());
  const partner = joint.partner === null ? null : (joint.scene?.findById(joint.partner) ?? null);
  const handle = (place: Vector3, name: 'anchor' | 'partnerAnchor', toLocal: Matrix4): Handle => ({
    place,
    drag(ray, step, viewDirection) {
      const plane = new Plane().setFromNormalAndCoplanarPoint(viewDirection, place);
      const point = ray.intersectPlane(plane, new Vector3());
      if (!point) return null;
      const value = tupleOf(point.applyMatrix4(toLocal), step);
      const label = t('Moved the anchor of {name}', { name: joint.gameObject.name });
      return new SetFields(label, [{ owner: joint, name, value }]);
    },
  });
  const inverse = (matrixWorld: Matrix4): Matrix4 => matrixWorld.clone().invert();
  return [
    handle(anchor, 'anchor', inverse(joint.gameObject.object3D.matrixWorld)),
    ...(far ? [handle(far, 'partnerAnchor', partner ? inverse(partner.object3D.matrixWorld) : new Matrix4())] : []),
  ];
}
