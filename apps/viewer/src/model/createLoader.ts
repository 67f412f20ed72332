import { makeKTX2Loader, showWhole } from '@farol/engine/files';
import type { LoadingManager, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/**
 * Makes a GLTFLoader with the decoders that a file needs; Draco, meshopt and KTX2 (Basis Universal) are fetched only
 * then.
 *
 * @param extensions - `extensionsUsed` of the file
 * @returns the loader, and a function that stops the decoders' workers
 */
export async function createLoader(
  extensions: readonly string[],
  manager: LoadingManager,
  renderer: WebGLRenderer,
): Promise<{ loader: GLTFLoader; dispose: () => void }> {
  const loader = new GLTFLoader(manager).register(showWhole);
  const disposables: { dispose(): unknown }[] = [];
  if (extensions.includes('KHR_draco_mesh_compression')) {
    const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js');
    const draco = new DRACOLoader();
    disposables.push(draco);
    loader.setDRACOLoader(draco);
  }
  if (extensions.includes('KHR_texture_basisu')) {
    const ktx2 = await makeKTX2Loader(renderer);
    disposables.push(ktx2);
    loader.setKTX2Loader(ktx2);
  }
  if (extensions.some((name) => name.endsWith('_meshopt_compression'))) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
    loader.setMeshoptDecoder(MeshoptDecoder);
  }
  return { loader, dispose: () => disposables.forEach((each) => each.dispose()) };
}
