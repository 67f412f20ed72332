import { shortText } from '@farol/editing';
import type { WebGLRenderer } from 'three';
import type { GLTFLoader, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { checkGltf } from '../guard/gltf/checkGltf';
import { checkModel } from '../guard/checkModel';
import { checkMemory, pictureMemory } from '../guard/pictures/pictureMemory';
import type { ReadOptions } from './loadAsset';
import { reserve } from './memory';
import { makeKTX2Loader } from './makeKTX2Loader';
import { restoreLights } from './lightExtras';
import { Model } from './Model';
import type { LightsIes } from './lightsIes';
import { binaryOf, type GltfJson, lightProfilesOf, LIGHTS_IES, readGltfJson } from '../guard/gltf/readGltfJson';

/** Makes a GLTFLoader with the decoders that a file needs; each is fetched on first use. */
async function loaderFor(
  extensions: readonly string[],
  renderer: WebGLRenderer | null,
): Promise<{ loader: GLTFLoader; dispose(): void }> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const loader = new GLTFLoader().register(showWhole);
  const disposables: { dispose(): unknown }[] = [];
  if (extensions.includes('KHR_texture_basisu')) {
    if (!renderer) throw new Error('it has KTX2 textures: give the AssetLibrary your WebGLRenderer.');
    const ktx2 = await makeKTX2Loader(renderer);
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

/** Bytes of a `data:` address; null for a damaged one and for other addresses. */
function bytesOfData(uri: string): Uint8Array | null {
  const [, base64, data = ''] = /^data:[^,]*?(;\s*base64\s*)?,([^]*)$/i.exec(uri) ?? [];
  try {
    const letters = data.replace(/%[\da-f]{2}/gi, (escape) =>
      String.fromCharCode(Number.parseInt(escape.slice(1), 16)),
    );
    const text = base64 ? atob(letters) : letters;
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
    return bytes;
  } catch {
    return null;
  }
}

const isData = (uri: unknown): uri is string => typeof uri === 'string' && /^data:/i.test(uri);

const dataSize = (uri: string): number | null =>
  isData(uri) ? Math.ceil(((uri.length - uri.indexOf(',') - 1) * 3) / 4) : null;

/** Encoded pictures embedded in a file; one that several images use is repeated, as it is decoded for each. */
function* picturesOf(json: GltfJson, binary: Uint8Array | null): Generator<Uint8Array> {
  const buffers = new Map<number, Uint8Array | null>();
  const bufferOf = (index: number): Uint8Array | null => {
    const uri = json.buffers?.[index]?.uri;
    if (uri === undefined) return index === 0 ? binary : null;
    if (!buffers.has(index)) buffers.set(index, isData(uri) ? bytesOfData(uri) : null);
    return buffers.get(index)!;
  };
  for (const { uri, bufferView } of json.images ?? []) {
    const view = bufferView === undefined ? null : json.bufferViews![bufferView];
    const start = view?.byteOffset ?? 0;
    const bytes = view
      ? bufferOf(view.buffer)?.subarray(start, start + view.byteLength)
      : isData(uri) && bytesOfData(uri);
    if (bytes) yield bytes;
  }
}

/**
 * Checks a glTF before a loader reads it: see `checkGltf`.
 * @param json - result of `readGltfJson`
 * @param sizeOf - returns the size (bytes) of a file that the glTF names; null when unknown
 * @returns decoded size of the pictures (bytes)
 * @throws Error that says in one sentence what is wrong with the glTF
 */
export function checkModelFile(
  bytes: ArrayBuffer,
  json: GltfJson,
  sizeOf: (uri: string) => number | null = () => null,
): number {
  const binary = binaryOf(bytes);
  checkGltf(json, { binary: binary?.length ?? 0, sizeOf: (uri) => dataSize(uri) ?? sizeOf(uri) });
  let pictures = 0;
  for (const picture of picturesOf(json, binary)) pictures += pictureMemory(picture);
  checkMemory(pictures, bytes.byteLength);
  return pictures;
}

/**
 * For `loader.register`: gives a file without scenes, which glTF allows, one scene of all its nodes.
 * @see glTF 2.0, 3.5.1
 */
export function showWhole({ json }: GLTFParser): { name: string } {
  const content = json as GltfContent;
  const { meshes = [], scenes = [] } = content;
  if (scenes.length === 0) {
    content.nodes ??= meshes.map((_, mesh) => ({ mesh }));
    const { nodes } = content;
    const below = new Set(nodes.flatMap(({ children = [] }) => children));
    json.scenes = [{ nodes: nodes.flatMap((_, i) => (below.has(i) ? [] : [i])) }];
    json.scene = 0;
  }
  return { name: 'FAROL_whole_file' };
}

/** Members of a glTF that decide whether it has anything to draw. */
interface GltfContent {
  readonly meshes?: readonly object[];
  readonly scenes?: readonly object[];
  nodes?: readonly { readonly mesh?: number; readonly children?: readonly number[] }[];
}

/** Turns an error of three's loaders into one sentence on the file. */
export function modelError(cause: unknown): Error {
  const said = cause instanceof Error ? cause.message.replace(/^THREE\.\w+:\s*/, '') : String(cause);
  if (cause instanceof Error && said.endsWith(' export it again.')) return cause;
  const reason = shortText(said, 160);
  // an error inside three's loader: the file has passed the checks, so it may not be to blame
  const isRaw = cause instanceof TypeError || cause instanceof RangeError;
  if (isRaw) return new Error(`three's loader cannot read it (${reason}): export it again.`, { cause });
  return new Error(`its glTF data are damaged or cut short (${reason}): export it again.`, { cause });
}

/**
 * Reads a glTF of one file: a GLB, or a .gltf with its data inside. A cancelled read has drawn nothing, so there is no
 * GPU memory to free.
 * @throws Error that says what is wrong with the bytes; the signal's abort reason
 */
export async function readModel(bytes: ArrayBuffer, options: ReadOptions = {}): Promise<Model> {
  const { renderer = null, signal } = options;
  const json = readGltfJson(bytes);
  reserve(options, 'pictures', checkModelFile(bytes, json));
  const named: { uri?: string }[] = [...(json.buffers ?? []), ...(json.images ?? []), ...lightProfilesOf(json)];
  const outside = named.find(({ uri }) => uri && !/^data:/i.test(uri));
  if (outside) throw new Error(`it needs ${shortText(outside.uri!, 120)}: choose both files together.`);
  const { loader, dispose } = await loaderFor(json.extensionsUsed ?? [], renderer);
  try {
    const lights: { ies?: LightsIes } = {};
    if (json.extensionsUsed?.includes(LIGHTS_IES)) {
      const { LightsIes } = await import('./lightsIes');
      loader.register((parser) => (lights.ies = new LightsIes(parser)));
    }
    signal?.throwIfAborted();
    const { scene, animations } = await loader.parseAsync(bytes, '');
    signal?.throwIfAborted();
    restoreLights(scene);
    await checkModel(scene, signal);
    return new Model(scene, animations, lights.ies?.profiles);
  } catch (cause) {
    signal?.throwIfAborted();
    throw modelError(cause);
  } finally {
    dispose();
  }
}
