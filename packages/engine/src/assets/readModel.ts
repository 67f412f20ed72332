import type { WebGLRenderer } from 'three';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { Model } from './Model';
import { readGltfJson } from './readGltfJson';

/** A GLTFLoader with the decoders that a file asks for; each is fetched when a file first uses it. */
async function loaderFor(
  extensions: readonly string[],
  renderer: WebGLRenderer | null,
): Promise<{ loader: GLTFLoader; dispose(): void }> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const loader = new GLTFLoader();
  const disposables: { dispose(): unknown }[] = [];
  if (extensions.includes('KHR_texture_basisu')) {
    if (!renderer) throw new Error('it has KTX2 textures: give the AssetLibrary the renderer that draws them.');
    const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js');
    const ktx2 = new KTX2Loader().detectSupport(renderer);
    disposables.push(ktx2);
    loader.setKTX2Loader(ktx2);
  }
  if (extensions.includes('KHR_draco_mesh_compression')) {
    const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js');
    const draco = new DRACOLoader();
    loader.setDRACOLoader(draco);
    disposables.push(draco);
  }
  if (extensions.some((name) => name.endsWith('_meshopt_compression'))) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
    loader.setMeshoptDecoder(MeshoptDecoder);
  }
  return { loader, dispose: () => disposables.forEach((each) => each.dispose()) };
}

/**
 * Reads a glTF of one file: a GLB, or a .gltf with its data inside.
 * @param renderer - draws it later; asked which compressed textures the device takes, needed for KTX2 only
 * @throws Error that says what is wrong with the bytes
 */
export async function readModel(bytes: ArrayBuffer, renderer: WebGLRenderer | null = null): Promise<Model> {
  const json = readGltfJson(bytes);
  const outside = [...(json.buffers ?? []), ...(json.images ?? [])].find(({ uri }) => uri && !/^data:/i.test(uri));
  if (outside) throw new Error(`it needs ${outside.uri}: choose both files together.`);
  const { loader, dispose } = await loaderFor(json.extensionsUsed ?? [], renderer);
  try {
    const { scene, animations } = await loader.parseAsync(bytes, '');
    return new Model(scene, animations);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message.replace(/^THREE\.\w+:\s*/, '') : String(cause);
    throw new Error(`its glTF data are damaged or cut short (${reason}): export it again.`, { cause });
  } finally {
    dispose();
  }
}
