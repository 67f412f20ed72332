import type { BufferGeometry, Object3D, Texture } from 'three';
import { counted } from '../core/counted';
import { readExrHeader } from '../guard/exr/readExrHeader';
import type { AssetMemory, DecodedPart } from './Asset';
import { checkPixels, imageSize, PixelsError } from '../guard/pictures/imageSize';
import type { ReadOptions } from './loadAsset';
import { signatureOf } from '../guard/signature';

/** Bytes that the files of a library may come to once decoded, whatever their size, and how many times their size beyond. */
const FREE = 2 ** 30;
const RATIO = 32;

/** @param decoded - bytes of all that is decoded @param files - bytes of all files @throws PixelsError when it is too much */
export function checkMemory(decoded: number, files: number): void {
  const limit = FREE + RATIO * files;
  if (decoded <= limit) return;
  const megabytes = (count: number): string => counted(Math.round(count / 1e6));
  throw new PixelsError(
    `the pictures and sounds would take ${megabytes(decoded)} MB once decoded, and ${megabytes(limit)} MB is the limit for files of so few bytes: make them smaller.`,
  );
}

/** Bytes that a picture takes once decoded; 0 where its head says nothing. @throws PixelsError for one of absurd size */
export function pictureMemory(bytes: Uint8Array): number {
  const said = signatureOf(bytes.slice(0, 16).buffer);
  const size = said === 'EXR' ? exrSize(bytes.slice().buffer) : imageSize(bytes);
  if (!size) return 0;
  checkPixels(size.width, size.height);
  // half floats, else bytes; four a pixel
  return size.width * size.height * (said === 'EXR' || said === 'HDR' ? 8 : 4);
}

function exrSize(bytes: ArrayBuffer): { width: number; height: number } | null {
  try {
    return readExrHeader(bytes);
  } catch (error) {
    if (error instanceof PixelsError) throw error;
    // told when it is read
    return null;
  }
}

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

/** The geometries below an object. */
export function geometriesOf(object: Object3D): Set<BufferGeometry> {
  const found = new Set<BufferGeometry>();
  object.traverse((each) => {
    const { geometry } = each as { geometry?: BufferGeometry };
    if (geometry) found.add(geometry);
  });
  return found;
}

/**
 * Counts what a part of an asset takes among all of its library.
 * @throws PixelsError when it would be too much, before it is decoded: it is not counted then
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

/** Equal for equal bytes; null where the browser makes no hashes. */
async function contentOf(bytes: ArrayBuffer): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;
  return new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)).join();
}

/** A texture of the same bytes that another asset has. */
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
 * Reads a texture: where another asset of the library has the same bytes, its picture is not decoded again.
 * @param kind - tells apart what is read from the same bytes in another way
 * @throws PixelsError (as a rejection) when it would be too much, before it is decoded
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
