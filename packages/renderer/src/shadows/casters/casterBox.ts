import {
  Box3,
  type BufferAttribute,
  type BufferGeometry,
  type Material,
  type Mesh,
  type MeshStandardMaterial,
  type Object3D,
} from 'three';
import { surfacesOf } from '../../materials/surfacesOf';
import { attributeState, isReadable } from '../../three/vertexData';
import { isAnimatedCaster } from './casterSignature';
import { moveBox } from './moveBox';

type AnyMesh = Mesh & { isInstancedMesh?: boolean; isBatchedMesh?: boolean; isPoints?: boolean };

/** Box of each geometry in its own space (m), with the `attributeState` of its positions when the box was computed. */
const boxes = new WeakMap<BufferGeometry, { readonly box: Box3; state: number }>();

const objectBox = new Float64Array(6);

/** Box of a geometry; null without positions, or when the CPU cannot read them and the page has set no box. */
function boxOf(geometry: BufferGeometry): Box3 | null {
  const { position } = geometry.attributes;
  if (position === undefined) return null;
  const state = attributeState(position);
  let known = boxes.get(geometry);
  if (known?.state !== state) {
    if (!isReadable(position)) return geometry.boundingBox;
    if (known === undefined) boxes.set(geometry, (known = { box: new Box3(), state }));
    known.state = state;
    known.box.setFromBufferAttribute(position as BufferAttribute);
  }
  return known.box;
}

/**
 * Greatest displacement of vertices by a material's shaders (m, in the object's own space); Infinity if the material
 * does not declare one.
 */
function reachOf(material: Material | null): number {
  return (material as MeshStandardMaterial | null)?.displacementMap ? Infinity : (surfacesOf(material)?.reach() ?? 0);
}

/**
 * Finds the box along the world's axes round an object; changes nothing of the object.
 * @param out - gets centre and half sizes (m), 6 numbers
 * @returns false for objects without a box: instances, batches, points, and objects that shaders displace without a declared
 *   reach
 */
export function casterBox(object: Object3D, out: Float64Array): boolean {
  const mesh = object as AnyMesh;
  if (mesh.isInstancedMesh || mesh.isBatchedMesh || mesh.isPoints) return false;
  if (isAnimatedCaster(object)) return false;
  let reach = 0;
  const { material } = mesh;
  if (!Array.isArray(material)) reach = reachOf(material);
  else for (let i = 0; i < material.length; i++) reach = Math.max(reach, reachOf(material[i]));
  if (reach === Infinity) return false;
  const box = boxOf(mesh.geometry);
  if (box === null || box.isEmpty()) return false;
  const { min, max } = box;
  objectBox[0] = 0.5 * (min.x + max.x);
  objectBox[1] = 0.5 * (min.y + max.y);
  objectBox[2] = 0.5 * (min.z + max.z);
  objectBox[3] = 0.5 * (max.x - min.x) + reach;
  objectBox[4] = 0.5 * (max.y - min.y) + reach;
  objectBox[5] = 0.5 * (max.z - min.z) + reach;
  moveBox(objectBox, 0, object.matrixWorld, out, 0);
  return Number.isFinite(out[0] + out[1] + out[2] + out[3] + out[4] + out[5]);
}

/**
 * True when a box lies wholly outside one of six planes.
 * @param planes - planes from `viewFrustumPlanes`, 6 × 4 numbers
 * @param box - centre and half sizes, from index `at` on
 */
export function boxOutsidePlanes(planes: Float64Array, box: Float64Array, at = 0): boolean {
  for (let i = 0; i < 24; i += 4) {
    const x = planes[i];
    const y = planes[i + 1];
    const z = planes[i + 2];
    const reach = Math.abs(x) * box[at + 3] + Math.abs(y) * box[at + 4] + Math.abs(z) * box[at + 5];
    if (x * box[at] + y * box[at + 1] + z * box[at + 2] + planes[i + 3] < -reach) return true;
  }
  return false;
}

/**
 * True when a box lies wholly inside six planes.
 * @param planes - planes from `viewFrustumPlanes`, 6 × 4 numbers
 * @param box - centre and half sizes, from index `at` on
 */
export function boxInsidePlanes(planes: Float64Array, box: Float64Array, at = 0): boolean {
  for (let i = 0; i < 24; i += 4) {
    const x = planes[i];
    const y = planes[i + 1];
    const z = planes[i + 2];
    const reach = Math.abs(x) * box[at + 3] + Math.abs(y) * box[at + 4] + Math.abs(z) * box[at + 5];
    if (x * box[at] + y * box[at + 1] + z * box[at + 2] + planes[i + 3] < reach) return false;
  }
  return true;
}
