import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import type { RivalGeometry } from './RivalScene';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** An attribute as floats, `size` per vertex, missing components 1; the attribute's own array if it has this layout. */
function floats(attribute: Attribute, size: number): Float32Array {
  const isPlain = !('isInterleavedBufferAttribute' in attribute) && attribute.array instanceof Float32Array;
  if (isPlain && attribute.itemSize === size) return attribute.array as Float32Array;
  const result = new Float32Array(attribute.count * size).fill(1);
  const parts = Math.min(size, attribute.itemSize);
  for (let i = 0; i < attribute.count; i++) {
    for (let k = 0; k < parts; k++) result[i * size + k] = attribute.getComponent(i, k);
  }
  return result;
}

/** Part of an index; 0, 1, 2 … for a geometry without one. */
function indicesOf({ index, attributes }: BufferGeometry, start: number, count: number): Uint16Array | Uint32Array {
  if (!index) return Uint32Array.from({ length: count }, (_, i) => start + i);
  const { array } = index;
  if (!(array instanceof Uint16Array) && !(array instanceof Uint32Array)) {
    return Uint32Array.from({ length: count }, (_, i) => index.getX(start + i));
  }
  return start === 0 && count === array.length && attributes.position.count > 0
    ? array
    : array.slice(start, start + count);
}

/**
 * Converts three's geometry, or the part with one material.
 * @param part - first index and number of indices; default all
 * @param isFlat - whether each triangle gets one normal, replacing the geometry's
 * @throws Error when it has no positions or no normals, or morph targets
 */
export function describeGeometry(
  geometry: BufferGeometry,
  part: { start: number; count: number } | null = null,
  isFlat = false,
): RivalGeometry {
  const name = geometry.name || 'without a name';
  if (isFlat) {
    const flat = geometry.index ? geometry.toNonIndexed() : geometry.clone();
    flat.computeVertexNormals();
    return describeGeometry(flat, part);
  }
  const { position, normal, uv, color } = geometry.attributes as Record<string, Attribute | undefined>;
  if (!position) throw new Error(`Geometry ${name} has no positions: give it some.`);
  if (!normal) throw new Error(`Geometry ${name} has no normals: compute them first.`);
  if (Object.keys(geometry.morphAttributes).length > 0) {
    throw new Error(`Geometry ${name} has morph targets: the Lab cannot give it to other engines.`);
  }
  const all = geometry.index ? geometry.index.count : position.count;
  const from = Math.max(part?.start ?? 0, geometry.drawRange.start);
  const to = Math.min(part ? part.start + part.count : all, geometry.drawRange.start + geometry.drawRange.count, all);
  const count = Math.max(0, to - from);
  return {
    positions: floats(position, 3),
    normals: floats(normal, 3),
    uvs: uv ? floats(uv, 2) : null,
    colours: color ? floats(color, 4) : null,
    indices: indicesOf(geometry, from, count - (count % 3)),
  };
}
