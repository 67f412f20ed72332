import type { Scene } from '@farol/engine';
import { gameObjectOf, type GameObject, rayHits } from '@farol/engine';
import {
  BufferAttribute,
  type Camera,
  InstancedMesh,
  type Intersection,
  Matrix4,
  Mesh,
  type Ray,
  Vector3,
} from 'three';
import { castByTree } from '../trees/castByTree';
import { vertexBesideRay } from './vertexBesideRay';

const world = new Matrix4();
const vertex = new Vector3();

/** Corner of the hit triangle closest to the hit (world). */
function nearestCorner({ object, face, instanceId, point }: Intersection): Vector3 | null {
  if (!(object instanceof Mesh) || !face) return null;
  world.copy(object.matrixWorld);
  if (instanceId !== undefined && object instanceof InstancedMesh) {
    object.getMatrixAt(instanceId, world);
    world.premultiply(object.matrixWorld);
  }
  const positions = object.geometry.getAttribute('position');
  if (!(positions instanceof BufferAttribute) && !('isInterleavedBufferAttribute' in positions)) return null;
  let nearest: Vector3 | null = null;
  let leastDistance = Infinity;
  for (const index of [face.a, face.b, face.c]) {
    object.getVertexPosition(index, vertex).applyMatrix4(world);
    const distance = vertex.distanceToSquared(point);
    if (distance >= leastDistance) continue;
    leastDistance = distance;
    nearest = vertex.clone();
  }
  return nearest;
}

/**
 * The visible vertex closest to a ray on screen, or else the closest corner of the first triangle hit. Null when there
 * is neither.
 * @param without - objects to ignore, with their descendants
 */
export function nearestVertex(
  scene: Scene,
  ray: Ray,
  camera: Camera,
  without: ReadonlySet<GameObject>,
): Vector3 | null {
  for (const hit of rayHits(scene, ray, camera, castByTree)) {
    let object = gameObjectOf(hit.object, hit.instanceId);
    while (object && !without.has(object)) object = object.parent;
    if (object) continue;
    const corner = nearestCorner(hit);
    if (corner) return vertexBesideRay(scene, ray, camera, without, hit.distance) ?? corner;
  }
  return vertexBesideRay(scene, ray, camera, without, Infinity);
}
