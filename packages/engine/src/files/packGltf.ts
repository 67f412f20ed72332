import { shortText } from '@farol/editing';
import { sampleOf } from './ProblemList';
import { checkGltf } from '../guard/gltf/checkGltf';
import {
  type GltfJson,
  lightProfilesOf,
  LIGHTS_IES,
  type LightProfileJson,
  readGltfJson,
} from '../guard/gltf/readGltfJson';
import { padded, writeGlb } from './writeGlb';

const mimeTypes: Readonly<Record<string, string>> = { png: 'image/png', webp: 'image/webp', ktx2: 'image/ktx2' };

function mimeOf(uri: string): string {
  const ending = /\.(\w+)$/.exec(uri.split(/[?#]/)[0].toLowerCase())?.[1] ?? '';
  return mimeTypes[ending] ?? 'image/jpeg';
}

async function bytesOfDataUri(uri: string): Promise<Uint8Array> {
  return new Uint8Array(await (await fetch(uri)).arrayBuffer());
}

/** Decodes an address; unchanged when its escapes are malformed. */
export function decodedUri(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/**
 * Packs a .gltf and the files that it names into one GLB, which is otherwise equal to the .gltf.
 * @param bytes - the .gltf
 * @param find - returns the bytes of a file that the glTF names; null when missing
 * @throws Error naming every file that is missing
 * @see glTF 2.0, 4.4
 */
export async function packGltf(
  bytes: ArrayBuffer,
  find: (uri: string) => Promise<ArrayBuffer | null>,
): Promise<ArrayBuffer> {
  const json = readGltfJson(bytes);
  checkGltf(json, { binary: 0, sizeOf: () => null });
  const parts: Uint8Array[] = [];
  const missing: string[] = [];
  let length = 0;
  /** Appends data to the buffer. @returns offset of the data (bytes) */
  const append = (part: Uint8Array): number => {
    const start = length;
    parts.push(part);
    length = padded(length + part.length);
    return start;
  };
  const read = async (uri: string): Promise<Uint8Array> => {
    if (/^data:/i.test(uri)) return bytesOfDataUri(uri);
    const found = await find(uri);
    if (found) return new Uint8Array(found);
    missing.push(shortText(decodedUri(uri), 80));
    return new Uint8Array();
  };

  const starts: number[] = [];
  for (const buffer of json.buffers ?? []) starts.push(buffer.uri ? append(await read(buffer.uri)) : 0);
  const views = (json.bufferViews ?? []).map((view) => ({
    ...view,
    buffer: 0,
    byteOffset: (view.byteOffset ?? 0) + (starts[view.buffer] ?? 0),
  }));
  const images: GltfJson['images'] = [];
  for (const image of json.images ?? []) {
    const { uri, ...rest } = image;
    if (uri === undefined) {
      images.push(image);
      continue;
    }
    const data = await read(uri);
    const mimeType = rest.mimeType ?? /^data:([^;,]+)/.exec(uri)?.[1] ?? mimeOf(uri);
    images.push({ ...rest, mimeType, bufferView: views.length });
    views.push({ buffer: 0, byteOffset: append(data), byteLength: data.length });
  }
  const profiles: LightProfileJson[] = [];
  for (const profile of lightProfilesOf(json)) {
    const { uri, ...rest } = profile;
    if (uri === undefined) {
      profiles.push(profile);
      continue;
    }
    const data = await read(uri);
    profiles.push({ ...rest, mimeType: 'application/x-ies-lm-63', bufferView: views.length });
    views.push({ buffer: 0, byteOffset: append(data), byteLength: data.length });
  }
  if (missing.length > 0) {
    throw new Error(`it needs ${sampleOf(new Set(missing))}: drop the whole folder, or all of its files together.`);
  }
  const whole = {
    ...json,
    ...(length > 0 ? { buffers: [{ byteLength: length }] } : {}),
    ...(views.length > 0 ? { bufferViews: views } : {}),
    ...(images.length > 0 ? { images } : {}),
    ...(profiles.length > 0
      ? { extensions: { ...json.extensions, [LIGHTS_IES]: { ...json.extensions?.[LIGHTS_IES], lights: profiles } } }
      : {}),
  };
  return writeGlb(JSON.stringify(whole), parts, length);
}
