import { type GameObject, gameObjectOf, hitPoint, type Scene } from '@farol/engine';
import type { Camera, Intersection, Vector2 } from 'three';
import { castByTree } from './trees/castByTree';

export interface PickHit {
  readonly object: GameObject;
  /** Distance of the hit from the ray's origin (m). */
  readonly distance: number;
}

/** Icons are picked first unless they are this much farther away (m) than the mesh at the same point. */
const ICON_REACH = 0.4;

const ownerOf = (hit: Intersection): GameObject | null => gameObjectOf(hit.object, hit.instanceId);

/**
 * The GameObject whose mesh is visible at a point; locked objects are ignored.
 * @param point - normalised device coordinates, -1 to 1, y up
 */
export function pick(scene: Scene, camera: Camera, point: Vector2): PickHit | null {
  const isFree = (each: Intersection): boolean => ownerOf(each)?.lockedInHierarchy === false;
  const hit = hitPoint(scene, camera, point, isFree, castByTree);
  const object = hit && ownerOf(hit);
  return object ? { object, distance: hit.distance } : null;
}

/** The GameObject picked at a point with an icon and a mesh: the icon's, unless it lies well behind the mesh. */
export const iconOrMesh = (icon: PickHit | null, mesh: PickHit | null): GameObject | null =>
  (icon && (!mesh || icon.distance < mesh.distance + ICON_REACH) ? icon : mesh)?.object ?? null;
