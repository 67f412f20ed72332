import { Box3, Vector3 } from 'three';
import { type MeshPart, meshParts } from './meshParts';
import type { ColliderPart } from './PhysicsParts';

/** The shape of a collider in the space of its object, before the object's scale. */
export interface ColliderShape {
  readonly kind: 'box' | 'sphere' | 'capsule' | 'cylinder' | 'hull' | 'mesh';
  /** Centre of the shape (m). */
  readonly centre: Vector3;
  /** Half extents of the shape's bounding box (m). */
  readonly half: Vector3;
  /** Axis of a capsule or cylinder: 0 x, 1 y, 2 z. */
  readonly axis: 0 | 1 | 2;
  /** Meshes that make a hull or mesh shape. */
  readonly parts: readonly MeshPart[];
}

const axes = { x: 0, y: 1, z: 2 } as const;

function boxOf(parts: readonly MeshPart[]): Box3 {
  const box = new Box3();
  const part = new Box3();
  for (const { geometry, matrix } of parts) {
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    box.union(part.copy(geometry.boundingBox!).applyMatrix4(matrix));
  }
  return box;
}

/** Shape of a collider by its fields; null for a mesh shape without a mesh. */
export function colliderShape(collider: ColliderPart): ColliderShape | null {
  const { scene, shape: kind } = collider;
  const axis = axes[collider.axis];
  const centre = new Vector3(...collider.offset);
  const needsMesh = kind === 'hull' || kind === 'mesh';
  if (!needsMesh && !collider.fit) {
    return { kind, centre, half: new Vector3(...collider.size).multiplyScalar(0.5), axis, parts: [] };
  }
  const parts = scene ? meshParts(collider.gameObject, scene) : [];
  const box = boxOf(parts);
  if (box.isEmpty()) return null;
  return {
    kind,
    centre: needsMesh ? centre.set(0, 0, 0) : box.getCenter(centre),
    half: box.getSize(new Vector3()).multiplyScalar(0.5),
    axis,
    parts: needsMesh ? parts : [],
  };
}
