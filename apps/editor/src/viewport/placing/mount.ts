import type { GameObject } from '@farol/engine';
import { Box3, Matrix4, Quaternion, Ray, Vector3 } from 'three';
import { boundsOf } from '../boundsOf';
import type { LandingView } from './land';
import { type Surface, surfacesAlong } from './surfaces';

/** Tags of objects that are mounted on a ceiling, or on a wall, which their back (+Z) touches. */
const MOUNTS = ['ceiling', 'wall'] as const;
export type Mount = (typeof MOUNTS)[number];

/** Height above the surface when no ceiling, or no wall, is found (m). */
const HEIGHTS: Readonly<Record<Mount, number>> = { ceiling: 2.6, wall: 1.6 };
/** Distance within which a ceiling above, or a wall behind, is searched (m). */
const REACH = 12;

const UP = new Vector3(0, 1, 0);

const faces: Readonly<Record<Mount, (normal: Vector3) => boolean>> = {
  ceiling: ({ y }) => y < -0.6,
  wall: ({ y }) => Math.abs(y) < 0.4,
};

/** Ceiling or wall that an object is mounted on, by its tags; null for other objects. */
export const mountOf = ({ tags }: GameObject): Mount | null => MOUNTS.find((mount) => tags.includes(mount)) ?? null;

/** The nearest ceiling or wall in a direction from a point. */
function beyond(view: LandingView, mount: Mount, { point, normal }: Surface, direction: Vector3): Surface | null {
  const ray = new Ray(point.clone().addScaledVector(normal, 0.01), direction);
  if (mount === 'wall') ray.origin.y += HEIGHTS.wall;
  const found = surfacesAlong(view.scene, ray, view.camera).find((each) => faces[mount](each.normal));
  return found && found.distance < REACH ? found : null;
}

/** Whether the hit object is large enough to carry an object of a size (m): lamps do not carry lamps. */
function carries(mount: Mount, { object }: Surface, size: Vector3): boolean {
  if (!object) return true;
  const there = boundsOf([object], new Box3(), false).getSize(new Vector3());
  const isWide = Math.max(there.x, there.z) > 1.2 * Math.max(size.x, size.z);
  return isWide && (mount === 'ceiling' ? Math.min(there.x, there.z) > Math.min(size.x, size.z) : there.y > size.y);
}

/** Place and facing of an object on a ceiling or a wall. */
export interface MountPlace {
  readonly point: Vector3;
  readonly rotation: Quaternion;
  /** Object with that ceiling or wall; null in free space. */
  readonly on: GameObject | null;
}

/**
 * Place on the ceiling or wall at the pointer, else on the ceiling above or the wall behind the surface there; else at
 * a usual height above that surface.
 * @param surfaces - surfaces at the pointer, nearest first
 * @param box - bounds of the object with its origin at 0
 */
export function mountPlace(
  view: LandingView,
  mount: Mount,
  surfaces: readonly Surface[],
  box: Box3,
): MountPlace | null {
  const back = new Vector3().setFromMatrixColumn(view.camera.matrixWorld, 2).setY(0);
  if (back.lengthSq() < 1e-6) back.set(0, 0, 1);
  back.normalize();
  const direction = mount === 'ceiling' ? UP : back.clone().negate();
  const size = box.getSize(new Vector3());
  let found: Surface | null = null;
  for (const each of surfaces) {
    if (faces[mount](each.normal)) found = carries(mount, each, size) ? each : null;
    // ceilings are searched above any surface; walls only behind floors, not behind small objects in front of them
    else if (mount === 'ceiling' || Math.abs(each.normal.y) > 0.6) found = beyond(view, mount, each, direction);
    if (found) break;
  }
  const seen = found ?? surfaces.at(0);
  if (!seen) return null;
  const point = seen.point.clone();
  if (!found) point.y += mount === 'ceiling' ? Math.max(HEIGHTS.ceiling, 0.3 - box.min.y) : HEIGHTS.wall;
  const facing = mount === 'wall' && found ? seen.normal.clone().setY(0).normalize() : back;
  // the front, -Z, points along the wall's normal
  const turn = new Matrix4().lookAt(new Vector3(), facing, UP);
  const rotation = mount === 'wall' ? new Quaternion().setFromRotationMatrix(turn) : new Quaternion();
  return { point, rotation, on: found?.object ?? null };
}
