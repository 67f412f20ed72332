import type { Collider } from '@farol/engine';
import { type ColliderShape, colliderShape } from '@farol/engine/physics';
import { Box3, type BufferGeometry, EdgesGeometry, Float32BufferAttribute, Matrix4, Quaternion, Vector3 } from 'three';
import { ConvexGeometry } from 'three/addons/geometries/ConvexGeometry.js';
import type { LineSet } from '../LineSet';

/** World pose and extents of a simple collider, as in the physics simulation. */
export interface ShapeFrame {
  readonly centre: Vector3;
  readonly rotation: Quaternion;
  /** Half extents along the axes of `rotation` (m). */
  readonly half: Vector3;
  /** World length of a unit along each axis of the object. */
  readonly scale: Vector3;
}

/** Maximum number of points of hulls and meshes that are drawn; larger ones are drawn as boxes. */
const MOST_POINTS = 20_000;

const edges = new WeakMap<BufferGeometry, { hull?: Float32Array; mesh?: Float32Array }>();
const matrix = new Matrix4();
const box = new Box3();
const a = new Vector3();
const b = new Vector3();
const axes = [new Vector3(), new Vector3(), new Vector3()] as const;

/** Pose of a box, sphere, capsule or cylinder, with the extents that the simulation uses. */
export function frameOf(shape: ColliderShape, matrixWorld: Matrix4): ShapeFrame {
  const [centre, rotation, scale] = [new Vector3(), new Quaternion(), new Vector3()];
  matrixWorld.decompose(centre, rotation, scale);
  centre.copy(shape.centre).applyMatrix4(matrixWorld);
  const size = new Vector3(Math.abs(scale.x), Math.abs(scale.y), Math.abs(scale.z));
  const half = size.clone().multiply(shape.half);
  if (shape.kind === 'sphere') half.setScalar(Math.max(half.x, half.y, half.z));
  else if (shape.kind !== 'box') {
    const { axis } = shape;
    const across = Math.max(half.getComponent((axis + 1) % 3), half.getComponent((axis + 2) % 3));
    const along = half.getComponent(axis);
    half.setScalar(across).setComponent(axis, shape.kind === 'capsule' ? Math.max(along, across) : along);
  }
  return { centre, rotation, half, scale };
}

/** Draws the shape of a collider; nothing while its mesh is not loaded. */
export function drawCollider(lines: LineSet, collider: Collider): void {
  const shape = colliderShape(collider);
  if (!shape) return;
  const { object3D } = collider.gameObject;
  object3D.updateWorldMatrix(true, false);
  if (shape.kind === 'hull' || shape.kind === 'mesh') drawParts(lines, shape, object3D.matrixWorld);
  else drawShape(lines, shape.kind, shape.axis, frameOf(shape, object3D.matrixWorld));
}

/** Draws a simple shape. @param axis - long axis of a capsule or cylinder */
export function drawShape(
  lines: LineSet,
  kind: 'box' | 'sphere' | 'capsule' | 'cylinder',
  axis: number,
  { centre, rotation, half }: ShapeFrame,
): void {
  if (kind === 'box') {
    matrix.compose(centre, rotation, a.set(1, 1, 1));
    lines.box(box.set(b.copy(half).negate(), half), matrix);
    return;
  }
  for (let i = 0; i < 3; i++) axes[i].set(0, 0, 0).setComponent(i, half.getComponent(i)).applyQuaternion(rotation);
  if (kind === 'sphere') {
    for (let i = 0; i < 3; i++) lines.circle(centre, axes[i], axes[(i + 1) % 3], 48);
    return;
  }
  const [up, u, v] = [axes[axis], axes[(axis + 1) % 3], axes[(axis + 2) % 3]];
  const radius = u.length();
  const rise = kind === 'capsule' ? Math.max(0, up.length() - radius) : up.length();
  const direction = up.clone().normalize();
  for (const sense of [1, -1]) {
    const end = centre.clone().addScaledVector(direction, sense * rise);
    lines.circle(end, u, v, 48);
    if (kind !== 'capsule') continue;
    const cap = direction.clone().multiplyScalar(radius * sense);
    halfCircle(lines, end, u, cap);
    halfCircle(lines, end, v, cap);
  }
  const [top, bottom] = [new Vector3(), new Vector3()];
  for (const side of [u, v]) {
    for (const sense of [1, -1]) {
      top.copy(centre).addScaledVector(direction, rise).addScaledVector(side, sense);
      bottom.copy(centre).addScaledVector(direction, -rise).addScaledVector(side, sense);
      lines.line(top, bottom);
    }
  }
}

function halfCircle(lines: LineSet, centre: Vector3, side: Vector3, top: Vector3): void {
  const [from, to] = [new Vector3(), new Vector3()];
  const at = (angle: number, target: Vector3): Vector3 =>
    target.copy(centre).addScaledVector(side, Math.cos(angle)).addScaledVector(top, Math.sin(angle));
  for (let i = 0; i < 16; i++) lines.line(at((Math.PI * i) / 16, from), at((Math.PI * (i + 1)) / 16, to));
}

function drawParts(lines: LineSet, { kind, parts, centre, half }: ColliderShape, matrixWorld: Matrix4): void {
  for (const part of parts) {
    const segments = segmentsOf(part.geometry, kind === 'hull' ? 'hull' : 'mesh');
    if (!segments) {
      lines.box(box.set(a.copy(centre).sub(half), b.copy(centre).add(half)), matrixWorld);
      continue;
    }
    matrix.multiplyMatrices(matrixWorld, part.matrix);
    for (let i = 0; i < segments.length; i += 6) {
      lines.line(a.fromArray(segments, i).applyMatrix4(matrix), b.fromArray(segments, i + 3).applyMatrix4(matrix));
    }
  }
}

/** Edges of a geometry, or of its convex hull; null when it has too many points. */
function segmentsOf(geometry: BufferGeometry, kind: 'hull' | 'mesh'): Float32Array | null {
  const positions = geometry.getAttribute('position');
  if (positions.count > MOST_POINTS) return null;
  let known = edges.get(geometry);
  if (!known) edges.set(geometry, (known = {}));
  known[kind] ??= makeSegments(geometry, kind);
  return known[kind];
}

function makeSegments(geometry: BufferGeometry, kind: 'hull' | 'mesh'): Float32Array {
  const positions = geometry.getAttribute('position');
  let shown = geometry;
  if (kind === 'hull') {
    const points = Array.from({ length: positions.count }, (_, i) => new Vector3().fromBufferAttribute(positions, i));
    // a hull needs at least four points; with fewer, the edges of the geometry itself are drawn
    shown = points.length < 4 ? geometry : new ConvexGeometry(points);
  }
  const made = new EdgesGeometry(shown, 1);
  const { array } = made.getAttribute('position') as Float32BufferAttribute;
  if (shown !== geometry) shown.dispose();
  made.dispose();
  return array as Float32Array;
}
