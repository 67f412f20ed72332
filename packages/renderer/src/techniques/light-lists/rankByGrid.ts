import type { Camera } from 'three';
import { LightGrid } from '../../lights/LightGrid';
import type { PictureSize } from '../../lights/PictureSize';
import { projectionFar, projectionNear } from '../../lights/projection';
import type { LightTable } from '../../lighting/LightTable';

/** Computes the light grid of a table; lights with a range get their ranks in the grid as records. */
export function rankByGrid(lights: LightTable, camera: Camera, { width, height }: PictureSize): void {
  const grid = (lights.grid ??= new LightGrid());
  const { elements } = camera.projectionMatrix;
  const cones = lights.coneCount > 0 ? lights.cones : null;
  const near = projectionNear(elements);
  grid.update(lights.boundeds.length, lights.spheres, elements, near, projectionFar(elements), width, height, cones);
  lights.order = grid.order;
  lights.bounded = grid.count;
}
