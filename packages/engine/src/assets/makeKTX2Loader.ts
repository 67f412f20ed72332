import type { WebGLRenderer } from 'three';
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

/**
 * A loader of KTX2 (Basis Universal), fetched when first asked for, that works where no text may be run as a program
 * (Content-Security-Policy without 'unsafe-eval'). Give it back by `dispose`.
 * @param renderer - asked which compressed textures the device takes
 */
export async function makeKTX2Loader(renderer: WebGLRenderer): Promise<KTX2Loader> {
  const { StrictKTX2Loader } = await import('./StrictKTX2Loader');
  return new StrictKTX2Loader().detectSupport(renderer);
}
