import { type Camera, Matrix4, Vector3 } from 'three';

/** A grid of clusters like that of three's ClusteredLightsNode. */
export interface ClusterGrid {
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
  /** Side of a tile (pixels). */
  readonly tile: number;
  /** Number of slices in depth, whose far ends grow by a constant factor. */
  readonly slices: number;
}

/** Load of the clusters of a scene. */
export interface ClusterFill {
  /** Number of lights in the fullest cluster. */
  readonly fullest: number;
  /** Number of lights that a cluster within their range lacks, because the cluster already holds `limit` lights. */
  readonly dropped: number;
}

/** Sphere lit by a light, in world space (m). */
export interface Reach {
  readonly centre: Vector3;
  readonly radius: number;
}

/**
 * Counts the lights of each cluster by the rule of the ClusteredLighting addon: spheres against the bounds of clusters
 * in view space, lists filled with the farthest lights first.
 *
 * @param limit - maximum number of lights in a cluster
 */
export function clusterFill(
  lights: readonly Reach[],
  camera: Camera & { readonly near: number; readonly far: number },
  { width, height, tile, slices }: ClusterGrid,
  limit = Infinity,
): ClusterFill {
  const across = Math.ceil(width / tile);
  const down = Math.ceil(height / tile);
  const counts = new Uint32Array(across * down * slices);
  const inverse = new Matrix4().copy(camera.matrixWorld).invert();
  const [scaleX, scaleY] = [1 / camera.projectionMatrix.elements[0], 1 / camera.projectionMatrix.elements[5]];
  const ratio = camera.far / camera.near;
  const depths = Array.from({ length: slices + 1 }, (_, z) => camera.near * ratio ** (z / slices));
  const views = lights
    .map(({ centre, radius }) => ({ centre: centre.clone().applyMatrix4(inverse), radius }))
    .sort((a, b) => a.centre.z - b.centre.z);
  let fullest = 0;
  let dropped = 0;
  for (const { centre, radius } of views) {
    let isDropped = false;
    for (let z = 0; z < slices; z++) {
      const [near, far] = [depths[z], depths[z + 1]];
      const outZ = outside(-centre.z, near, far);
      if (outZ > radius) continue;
      for (let y = 0; y < down; y++) {
        const outY = outside(centre.y, ...bounds(1 - (2 * (y + 1)) / down, 1 - (2 * y) / down, near, far, scaleY));
        if (outZ ** 2 + outY ** 2 > radius ** 2) continue;
        for (let x = 0; x < across; x++) {
          const outX = outside(
            centre.x,
            ...bounds((2 * x) / across - 1, (2 * (x + 1)) / across - 1, near, far, scaleX),
          );
          if (outX ** 2 + outY ** 2 + outZ ** 2 > radius ** 2) continue;
          const count = ++counts[x + across * (y + down * z)];
          if (count > fullest) fullest = count;
          if (count > limit) isDropped = true;
        }
      }
    }
    if (isDropped) dropped++;
  }
  return { fullest, dropped };
}

/** Distance of a number from an interval; 0 inside. */
const outside = (value: number, low: number, high: number): number => Math.max(low - value, value - high, 0);

/** Extent in view space of a range of normalised device coordinates, between two depths. */
function bounds(low: number, high: number, near: number, far: number, scale: number): [number, number] {
  return [Math.min(low * near, low * far) * scale, Math.max(high * near, high * far) * scale];
}
