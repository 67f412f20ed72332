import type { CheckedBakeOptions } from '../checkOptions';
import type { UnwrappedMeshes } from '../unwrap/unwrapStaticMeshes';
import { WorkerPool } from '../worker/WorkerPool';

/**
 * Runs `stitchLightmap` on all lightmaps, in workers.
 *
 * @param lightmaps - four floats per texel; replaced by the stitched ones
 */
export async function stitchSeams(
  lightmaps: Float32Array[],
  { unwrapped, surfaces }: UnwrappedMeshes,
  { size, signal }: Pick<CheckedBakeOptions, 'size' | 'signal'>,
): Promise<void> {
  const pool = await WorkerPool.make(lightmaps.length, signal);
  try {
    await Promise.all(
      lightmaps.map(async (data, lightmap) => {
        const meshes = unwrapped.flatMap((each, i) =>
          each?.lightmap === lightmap ? [{ surface: surfaces[i]!, unwrapped: each }] : [],
        );
        const question = { kind: 'stitch', request: { size, data, meshes } } as const;
        lightmaps[lightmap] = await pool.ask(question, { transfer: [data.buffer] });
      }),
    );
  } finally {
    pool.dispose();
  }
}
