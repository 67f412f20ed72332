import { hasReadableVertices } from '../../three/vertexData';
import { type BufferGeometry, InstancedBufferGeometry, InterleavedBuffer, InterleavedBufferAttribute } from 'three';

/**
 * Makes an instanced copy of a geometry, with no instances yet. Attributes are copied, since three deletes their GPU buffers
 * when any geometry with them is disposed. Attributes that the CPU cannot read are left out.
 */
export function instancesOf(geometry: BufferGeometry | null): InstancedBufferGeometry {
  const instanced = new InstancedBufferGeometry();
  instanced.instanceCount = 0;
  if (geometry === null) return instanced;
  if (!hasReadableVertices(geometry)) {
    console.warn('Farol: mesh particles copy their geometry; keep its arrays, which were freed after upload.');
    return instanced;
  }
  const buffers = new Map<InterleavedBufferAttribute['data'], InterleavedBuffer>();
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (!(attribute instanceof InterleavedBufferAttribute)) {
      instanced.setAttribute(name, attribute.clone());
      continue;
    }
    const { data, itemSize, offset, normalized } = attribute;
    // attributes that share an interleaved buffer also share its copy
    const buffer = buffers.get(data) ?? new InterleavedBuffer(data.array.slice(), data.stride);
    buffers.set(data, buffer);
    instanced.setAttribute(name, new InterleavedBufferAttribute(buffer, itemSize, offset, normalized));
  }
  if (geometry.index !== null) instanced.setIndex(geometry.index.clone());
  return instanced;
}
