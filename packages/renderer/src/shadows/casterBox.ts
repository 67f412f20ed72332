import {
  Box3,
  type BufferAttribute,
  type BufferGeometry,
  type Mesh,
  type MeshStandardMaterial,
  type Object3D,
} from 'three';
import { isAnimatedCaster } from './casterSignature';

type Kind = Mesh & { isInstancedMesh?: boolean; isBatchedMesh?: boolean; isPoints?: boolean };

/** Boxes of geometries in their own space, with the version of the positions that they are of. */
const boxes = new WeakMap<BufferGeometry, { readonly box: Box3; version: number; position: BufferAttribute }>();

function boxOf(geometry: BufferGeometry): Box3 | null {
  const position = geometry.attributes.position as BufferAttribute | undefined;
  if (position === undefined) return null;
  const { version = 0 } = position;
  let known = boxes.get(geometry);
  if (known === undefined || known.position !== position || known.version !== version) {
    const box = (known?.box ?? new Box3()).setFromBufferAttribute(position);
    boxes.set(geometry, (known = { box, version, position }));
  }
  return known.box;
}

function isDisplaced(object: Kind): boolean {
  const { material } = object;
  const displaces = (one: unknown) => Boolean((one as MeshStandardMaterial).displacementMap);
  return Array.isArray(material) ? material.some(displaces) : displaces(material);
}

/**
 * The box along the world's axes round an object: centre and half sizes (m), 6 numbers. Nothing of the object is changed.
 * @returns false for objects that have none: several at once, points with a size, or bent by shaders
 */
export function casterBox(object: Object3D, out: Float64Array): boolean {
  const mesh = object as Kind;
  if (mesh.isInstancedMesh || mesh.isBatchedMesh || mesh.isPoints) return false;
  if (isDisplaced(mesh) || isAnimatedCaster(object)) return false;
  const box = boxOf(mesh.geometry);
  if (box === null || box.isEmpty()) return false;
  const { min, max } = box;
  const e = object.matrixWorld.elements;
  const x = 0.5 * (min.x + max.x);
  const y = 0.5 * (min.y + max.y);
  const z = 0.5 * (min.z + max.z);
  const a = 0.5 * (max.x - min.x);
  const b = 0.5 * (max.y - min.y);
  const c = 0.5 * (max.z - min.z);
  for (let i = 0; i < 3; i++) {
    out[i] = e[i] * x + e[4 + i] * y + e[8 + i] * z + e[12 + i];
    out[3 + i] = Math.abs(e[i]) * a + Math.abs(e[4 + i]) * b + Math.abs(e[8 + i]) * c;
  }
  return Number.isFinite(out[0] + out[1] + out[2] + out[3] + out[4] + out[5]);
}

/** True when a box lies wholly on the outer side of one of six planes, as `viewFrustumPlanes` has them. */
export function boxOutsidePlanes(planes: Float64Array, box: Float64Array): boolean {
  for (let i = 0; i < 24; i += 4) {
    const x = planes[i];
    const y = planes[i + 1];
    const z = planes[i + 2];
    const reach = Math.abs(x) * box[3] + Math.abs(y) * box[4] + Math.abs(z) * box[5];
    if (x * box[0] + y * box[1] + z * box[2] + planes[i + 3] < -reach) return true;
  }
  return false;
}

/** Square of the distance from a point to a box, 0 inside (m²). */
export function squaredDistanceToBox(box: Float64Array, x: number, y: number, z: number): number {
  const dx = Math.max(0, Math.abs(x - box[0]) - box[3]);
  const dy = Math.max(0, Math.abs(y - box[1]) - box[4]);
  const dz = Math.max(0, Math.abs(z - box[2]) - box[5]);
  return dx * dx + dy * dy + dz * dz;
}
