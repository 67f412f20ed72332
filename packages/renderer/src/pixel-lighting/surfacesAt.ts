import { type Camera, type Intersection, Material, Mesh, type Object3D, Raycaster, Vector2 } from 'three';
import type { PixelSurface } from './PixelLighting';

interface Drawn extends Object3D {
  readonly material?: Material | readonly Material[];
  readonly isDecal?: boolean;
}

/** Surfaces under a point of the picture, nearest first, up to the first opaque one. */
export function surfacesAt(root: Object3D, camera: Camera, x: number, y: number): PixelSurface[] {
  if (!('isPerspectiveCamera' in camera || 'isOrthographicCamera' in camera)) return [];
  const raycaster = new Raycaster();
  raycaster.layers.mask = camera.layers.mask;
  raycaster.setFromCamera(new Vector2(x, y), camera);
  const surfaces: PixelSurface[] = [];
  for (const hit of raycaster.intersectObject(root)) {
    const material = materialOf(hit);
    if (material === null || !material.visible || !isVisible(hit.object)) continue;
    const { object, point, distance, instanceId = null } = hit;
    surfaces.push({ object, instanceId, material, point, distance });
    const { transmission = 0 } = material as Material & { transmission?: number };
    if (!material.transparent && transmission === 0) break;
  }
  return surfaces;
}

function materialOf({ object, face }: Intersection): Material | null {
  const { material, isDecal } = object as Drawn;
  if (material === undefined || isDecal === true) return null;
  if (material instanceof Material) return material;
  return object instanceof Mesh ? ((material as readonly Material[])[face?.materialIndex ?? 0] ?? null) : null;
}

function isVisible(object: Object3D | null): boolean {
  for (let each = object; each !== null; each = each.parent) if (!each.visible) return false;
  return true;
}
