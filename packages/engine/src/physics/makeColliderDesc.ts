import type { ColliderDesc } from '@dimforge/rapier3d-compat';
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { ColliderShape } from './colliderShape';
import type { Rapier } from './loadRapier';
import type { MeshPart } from './meshParts';

const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();
const turn = new Quaternion();
const point = new Vector3();
const toBody = new Matrix4();
const X = new Vector3(1, 0, 0);
const Z = new Vector3(0, 0, 1);

/** Smallest half extent of a shape (m): a flat mesh becomes a thin box. */
const THINNEST = 0.001;

function pointsOf(parts: readonly MeshPart[], matrix: Matrix4): Float32Array {
  const points: number[] = [];
  for (const part of parts) {
    toBody.multiplyMatrices(matrix, part.matrix);
    const positions = part.geometry.getAttribute('position');
    for (let i = 0; i < positions.count; i++) {
      point.fromBufferAttribute(positions, i).applyMatrix4(toBody);
      points.push(point.x, point.y, point.z);
    }
  }
  return Float32Array.from(points);
}

function indicesOf(parts: readonly MeshPart[]): Uint32Array {
  const indices: number[] = [];
  let first = 0;
  for (const { geometry } of parts) {
    const { count } = geometry.getAttribute('position');
    const index = geometry.getIndex();
    const length = index ? index.count : count;
    for (let i = 0; i + 2 < length; i += 3) {
      for (let k = i; k < i + 3; k++) indices.push(first + (index ? index.getX(k) : k));
    }
    first += count;
  }
  return Uint32Array.from(indices);
}

/**
 * Rapier's description of a shape, placed in its body.
 * @param matrix - from the collider's object to the body, whose space has no scale
 * @returns null when the points of a hull or mesh span no shape
 */
export function makeColliderDesc(
  { ColliderDesc: Desc }: Rapier,
  shape: ColliderShape,
  matrix: Matrix4,
): ColliderDesc | null {
  const { kind, axis } = shape;
  if (kind === 'hull' || kind === 'mesh') {
    toBody.makeTranslation(shape.centre);
    const points = pointsOf(shape.parts, new Matrix4().multiplyMatrices(matrix, toBody));
    if (!points.every(Number.isFinite)) return null;
    if (kind === 'hull') return Desc.convexHull(points);
    const indices = indicesOf(shape.parts);
    return indices.length === 0 ? null : Desc.trimesh(points, indices);
  }
  matrix.decompose(position, rotation, scale);
  position.copy(shape.centre).applyMatrix4(matrix);
  const half = scale.set(Math.abs(scale.x), Math.abs(scale.y), Math.abs(scale.z)).multiply(shape.half);
  half.clampScalar(THINNEST, Infinity);
  const along = half.getComponent(axis);
  const across = Math.max(half.getComponent((axis + 1) % 3), half.getComponent((axis + 2) % 3));
  let desc: ColliderDesc;
  if (kind === 'box') desc = Desc.cuboid(half.x, half.y, half.z);
  else if (kind === 'sphere') desc = Desc.ball(Math.max(half.x, half.y, half.z));
  else {
    // Rapier's capsules and cylinders stand along y
    if (axis === 0) rotation.multiply(turn.setFromAxisAngle(Z, -Math.PI / 2));
    else if (axis === 2) rotation.multiply(turn.setFromAxisAngle(X, Math.PI / 2));
    if (kind === 'cylinder') desc = Desc.cylinder(along, across);
    else desc = Desc.capsule(Math.max(along - across, THINNEST), across);
  }
  desc.translation = position.clone();
  desc.rotation = rotation.clone();
  return desc;
}
