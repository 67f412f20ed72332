import type { BufferAttribute, BufferGeometry, GLBufferAttribute, InterleavedBufferAttribute } from 'three';

/** Any vertex attribute of three's: with its own array, part of an interleaved one, or only a WebGL buffer. */
export type VertexAttribute = BufferAttribute | InterleavedBufferAttribute | GLBufferAttribute;

type AnyAttribute = Partial<BufferAttribute & InterleavedBufferAttribute & GLBufferAttribute>;

/** Negative ids for buffers that have none in three. */
const ids = new WeakMap<object, number>();
let lastId = 0;

/** Version of an attribute's data, shared by interleaved attributes of one buffer. */
export function attributeVersion(attribute: VertexAttribute): number {
  const { data, version } = attribute as AnyAttribute;
  return data === undefined ? version! : data.version;
}

/** Id of the storage of an attribute's data: attributes with equal id and `attributeVersion` have the same data. */
export function attributeId(attribute: VertexAttribute): number {
  const { data, buffer, offset, id } = attribute as AnyAttribute & { id?: number };
  if (id !== undefined) return id;
  const storage = (data ?? buffer ?? attribute) as object;
  let number = ids.get(storage);
  if (number === undefined) ids.set(storage, (number = --lastId));
  // offsets are below 256, the largest stride in WebGL (bytes)
  return number * 256 - (offset ?? 0);
}

/** Number that changes with an attribute's data: combines `attributeId` and `attributeVersion`. */
export function attributeState(attribute: VertexAttribute): number {
  return attributeId(attribute) * 65_536 + attributeVersion(attribute);
}

/** True for data that the GPU may write without a change of version. */
export function isOnGPU(attribute: VertexAttribute | undefined): boolean {
  return (attribute as AnyAttribute | undefined)?.isGLBufferAttribute === true;
}

/** False for data that only the GPU has: a `GLBufferAttribute`'s, or data freed by the page after upload. */
export function isReadable(attribute: VertexAttribute): boolean {
  if (isOnGPU(attribute)) return false;
  const { array, count, data, itemSize } = attribute as BufferAttribute & Partial<InterleavedBufferAttribute>;
  return (array as ArrayLike<number> | null) !== null && array.length >= count * (data?.stride ?? itemSize);
}

/** Whether the CPU can read a geometry's positions and index. */
export function hasReadableVertices({ attributes, index }: BufferGeometry): boolean {
  const { position } = attributes;
  return position !== undefined && isReadable(position) && (index === null || isReadable(index));
}
