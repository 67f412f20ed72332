import type { BufferGeometry, Object3D, Texture } from 'three';
import type { AssetMemory, DecodedPart } from './Asset';
import { checkMemory, pictureMemory } from '../guard/pictures/pictureMemory';
import type { ReadOptions } from './loadAsset';

/** Bytes of the vertices and indices of a mesh or a model. */
export function geometryMemory(geometries: Iterable<BufferGeometry>): number {
  const buffers = new Set<ArrayBufferLike>();
  for (const { attributes, morphAttributes, index } of geometries) {
    for (const attribute of [...Object.values(attributes), ...Object.values(morphAttributes).flat()])
      buffers.add(('data' in attribute ? attribute.data : attribute).array.buffer);
    if (index) buffers.add(index.array.buffer);
  }
  return [...buffers].reduce((sum, { byteLength }) => sum + byteLength, 0);
}

export function geometriesOf(object: Object3D): Set<BufferGeometry> {
  const found = new Set<BufferGeometry>();
  object.traverse((each) => {
    const { geometry } = each as { geometry?: BufferGeometry };
    if (geometry) found.add(geometry);
  });
  return found;
}

/**
 * Adds a part of an asset to the memory account of its library, before the part is decoded.
 * @throws PixelsError when the library would exceed its limit; the part is not counted then
 */
export function reserve({ memory }: ReadOptions, content: string, bytes: number): void {
  if (!memory) return;
  const { own, all } = memory;
  own.decoded.set(content, { bytes });
  let files = 0;
  let decoded = 0;
  const shared = new Set<string>();
  for (const each of new Set([...all(), own])) {
    files += each.file;
    for (const [key, part] of each.decoded) {
      if (part.texture && shared.has(key)) continue;
      if (part.texture) shared.add(key);
      decoded += part.bytes;
    }
  }
  try {
    checkMemory(decoded, files);
  } catch (error) {
    own.decoded.delete(content);
    throw error;
  }
}

/** Hash of an asset's bytes; null where the browser offers no hashes. */
async function contentOf(bytes: ArrayBuffer): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;
  return new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)).join();
}

/** Texture that another asset has read from equal bytes. */
async function equalTexture(all: Iterable<AssetMemory>, content: string): Promise<Required<DecodedPart> | null> {
  for (const { decoded } of all) {
    const part = decoded.get(content);
    if (!part?.texture) continue;
    const texture = await part.texture.catch(() => null);
    if (texture) return { bytes: part.bytes, texture: Promise.resolve(texture.clone()) };
  }
  return null;
}

/**
 * Reads a texture; an image with the same bytes as one of another asset of the library is not decoded again.
 * @param kind - distinguishes textures read in different ways from equal bytes
 * @throws PixelsError (as a rejection) when the library would exceed its limit, before decoding
 */
export async function readOnce(
  bytes: ArrayBuffer,
  kind: string,
  options: ReadOptions,
  read: () => Promise<Texture> | Texture,
): Promise<Texture> {
  const { memory } = options;
  const size = pictureMemory(new Uint8Array(bytes));
  const hash = memory ? await contentOf(bytes) : null;
  if (!memory) return read();
  const { own, all } = memory;
  const content = `${kind} ${hash}`;
  const equal = hash && (await equalTexture(all(), content));
  if (equal) {
    own.decoded.set(content, equal);
    return equal.texture;
  }
  reserve(options, content, size);
  const texture = Promise.resolve(read());
  own.decoded.set(content, hash ? { bytes: size, texture } : { bytes: size });
  texture.catch(() => own.decoded.delete(content));
  return texture;
}
