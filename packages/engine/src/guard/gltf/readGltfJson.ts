import { shortText } from '@farol/editing';
import { checkSignature } from '../signature';

/** The extension by which nodes have lights with photometric profiles. */
export const LIGHTS_IES = 'EXT_lights_ies';

/** JSON of a glTF file: the parts that are read before the loader runs. @see glTF 2.0, 3.1 */
export interface GltfJson {
  asset?: { version?: string };
  extensionsUsed?: string[];
  buffers?: { uri?: string; byteLength?: number }[];
  bufferViews?: { buffer: number; byteOffset?: number; byteLength: number }[];
  images?: { uri?: string; mimeType?: string; bufferView?: number }[];
  extensions?: { [LIGHTS_IES]?: { lights?: LightProfileJson[] } };
  /** Index of the default scene. */
  scene?: number;
}

/** A photometric profile in a glTF: in a file, or in a buffer view. @see EXT_lights_ies */
export interface LightProfileJson {
  name?: string;
  uri?: string;
  bufferView?: number;
  mimeType?: string;
}

/** Photometric profiles of an unchecked glTF; none if their list is no array. */
export function lightProfilesOf({ extensions }: GltfJson): readonly LightProfileJson[] {
  const lights: unknown = extensions?.[LIGHTS_IES]?.lights;
  return Array.isArray(lights) ? lights.filter((each) => typeof each === 'object' && each !== null) : [];
}

const glbMagic = 0x46546c67;
const jsonChunk = 0x4e4f534a;

/**
 * Reads the JSON of a .glb or .gltf file.
 *
 * @throws Error that says what is wrong with the bytes
 * @see glTF 2.0, 4.4: header of 12 bytes, then chunks of length, type and data
 */
export function readGltfJson(bytes: ArrayBuffer): GltfJson {
  checkSignature(bytes, 'glTF');
  const view = new DataView(bytes);
  const isBinary = bytes.byteLength >= 4 && view.getUint32(0, true) === glbMagic;
  const json = parseJson(isBinary ? binaryJson(view) : bytes);
  if (typeof json !== 'object' || json === null || !('asset' in json)) {
    throw new Error("it is not a glTF, whose 'asset' is missing: choose another file.");
  }
  const version = shortText(String((json as GltfJson).asset?.version ?? 'of no version'));
  if (!version.startsWith('2.')) throw new Error(`it is glTF ${version}, and only glTF 2.x can be read: convert it.`);
  return json as GltfJson;
}

const binaryChunk = 0x004e4942;

/** The binary chunk of a GLB; null without one, as for a .gltf. Call `readGltfJson` first, which checks the file. */
export function binaryOf(bytes: ArrayBuffer): Uint8Array<ArrayBuffer> | null {
  const view = new DataView(bytes);
  if (view.getUint32(0, true) !== glbMagic) return null;
  const at = 20 + view.getUint32(12, true);
  if (at + 8 > bytes.byteLength || view.getUint32(at + 4, true) !== binaryChunk) return null;
  return new Uint8Array(bytes, at + 8, Math.min(view.getUint32(at, true), bytes.byteLength - at - 8));
}

function binaryJson(view: DataView): ArrayBuffer {
  if (view.byteLength < 20)
    throw new Error(`it is cut short (${view.byteLength} bytes are less than a GLB header): export it again.`);
  const version = view.getUint32(4, true);
  if (version !== 2) throw new Error(`it is GLB version ${version}, and only version 2 can be read: convert it.`);
  const length = view.getUint32(8, true);
  if (length > view.byteLength) {
    throw new Error(
      `it is cut short (its header says ${length} bytes, and it has ${view.byteLength}): export it again.`,
    );
  }
  const chunkLength = view.getUint32(12, true);
  if (view.getUint32(16, true) !== jsonChunk || 20 + chunkLength > view.byteLength) {
    throw new Error('its first chunk is not complete JSON: export it again.');
  }
  return (view.buffer as ArrayBuffer).slice(20, 20 + chunkLength);
}

function parseJson(bytes: ArrayBuffer): unknown {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch (error) {
    throw new Error(`its JSON cannot be read (${shortText((error as Error).message, 160)}): export it again.`, {
      cause: error,
    });
  }
}
