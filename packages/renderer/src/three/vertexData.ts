import type { BufferAttribute, BufferGeometry, GLBufferAttribute, InterleavedBufferAttribute } from 'three';

/** An attribute as three draws it: with an array of its own, a share of one, or a buffer that WebGL alone can read. */
export type VertexAttribute = BufferAttribute | InterleavedBufferAttribute | GLBufferAttribute;

type AnyAttribute = Partial<BufferAttribute & InterleavedBufferAttribute & GLBufferAttribute>;

/** Negative numbers for buffers that three gives no id. */
const ids = new WeakMap<object, number>();
let lastId = 0;

/** Version of an attribute's data, which interleaved attributes of one buffer share. */
export function attributeVersion(attribute: VertexAttribute): number {
  const { data, version } = attribute as AnyAttribute;
  return data === undefined ? version! : data.version;
}

/**
 * Number of the storage of an attribute's data: attributes with equal numbers and `attributeVersion` have the same
 * data.
 */
export function attributeId(attribute: VertexAttribute): number {
  const { data, buffer, offset, id } = attribute as AnyAttribute & { id?: number };
  if (id !== undefined) return id;
  const storage = (data ?? buffer ?? attribute) as object;
  let number = ids.get(storage);
  if (number === undefined) ids.set(storage, (number = --lastId));
  // an offset is below 256, the largest stride that WebGL takes (bytes)
  return number * 256 - (offset ?? 0);
}

/** Number that changes with an attribute's data: `attributeId` and `attributeVersion` in one. */
export function attributeState(attribute: VertexAttribute): number {
  return attributeId(attribute) * 65_536 + attributeVersion(attribute);
}

/** True for data that the GPU may write without a change of version. */
export function isOnGPU(attribute: VertexAttribute | undefined): boolean {
  return (attribute as AnyAttribute | undefined)?.isGLBufferAttribute === true;
}

/** False for data that only the GPU has: of a `GLBufferAttribute`, or freed by the page after three's upload. */
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
