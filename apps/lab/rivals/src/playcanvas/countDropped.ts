import { type AppBase, Vec3 } from 'playcanvas';

/** PlayCanvas's private data of a frame's clusters. */
interface Clusters {
  /** Lights in use; the first entry is empty. */
  readonly usedLights: readonly unknown[];
  readonly cells: Vec3;
  readonly maxCellLightCount: number;
  evalLightCellMinMax(light: unknown, min: Vec3, max: Vec3): void;
}

interface Internals {
  readonly renderer: { readonly worldClustersAllocator: { readonly _allocated: readonly Clusters[] } };
}

/** Number of lights of the last frame that PlayCanvas's rule leaves out of some full cell. */
export function countDropped(app: AppBase): number {
  const [clusters] = (app as unknown as Internals).renderer.worldClustersAllocator._allocated;
  if (!clusters) return 0;
  const { usedLights, cells, maxCellLightCount } = clusters;
  const counts = new Int32Array(cells.x * cells.y * cells.z);
  const [min, max] = [new Vec3(), new Vec3()];
  let dropped = 0;
  for (const light of usedLights.slice(1)) {
    clusters.evalLightCellMinMax(light, min, max);
    let isDropped = false;
    for (let x = min.x; x <= max.x; x++) {
      for (let z = min.z; z <= max.z; z++) {
        for (let y = min.y; y <= max.y; y++) {
          if (++counts[x + cells.x * (z + y * cells.z)] > maxCellLightCount) isDropped = true;
        }
      }
    }
    if (isDropped) dropped++;
  }
  return dropped;
}
