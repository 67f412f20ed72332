import type { WebGLRenderer } from 'three';
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

/**
 * A loader of KTX2 (Basis Universal), fetched when first needed, that works under a Content-Security-Policy without
 * 'unsafe-eval'. Dispose of it after use.
 * @param renderer - tells which compressed formats the device supports
 */
export async function makeKTX2Loader(renderer: WebGLRenderer): Promise<KTX2Loader> {
  const { StrictKTX2Loader } = await import('./StrictKTX2Loader');
  return new StrictKTX2Loader().detectSupport(renderer);
}
