import type { Scene, WebGLRenderer } from 'three';
import { bakeLightmaps } from './bakeLightmaps';
import type { TraceOptions } from './BakeOptions';
import type { BakedProbes } from './probes/BakedProbes';

/** Options of `bakeProbes`. */
export interface BakeProbesOptions extends TraceOptions {
  /**
   * Side of the lightmap that stores reflected light during tracing (texels): a multiple of 16, 16 to 8,192. Default
   * 512.
   */
  size?: number;
}

/**
 * Bakes the direct and reflected light at points, for moving objects. For lightmaps as well, pass `probes` to {@link
 * bakeLightmaps}, which traces the scene once for both.
 *
 * @param points - three numbers per point, world space (m)
 */
export async function bakeProbes(
  renderer: WebGLRenderer,
  scene: Scene,
  points: Float32Array,
  options: BakeProbesOptions = {},
): Promise<BakedProbes> {
  const whole = { size: 512, ...options, showProgress: false, probes: points };
  const bake = await bakeLightmaps(renderer, scene, whole);
  bake.dispose();
  return bake.probes!;
}
