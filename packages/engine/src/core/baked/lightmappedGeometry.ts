import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three';
import type { LightmappedMesh } from '../../assets/bake/BakeData';

/** Copies the elements of an attribute that `source` lists by their vertex indices. */
function gathered(attribute: BufferAttribute | InterleavedBufferAttribute, source: Uint32Array): BufferAttribute {
  const { itemSize, normalized } = attribute;
  const from = attribute.array;
  const isInterleaved = 'isInterleavedBufferAttribute' in attribute;
  const stride = isInterleaved ? (attribute as InterleavedBufferAttribute).data.stride : itemSize;
  const offset = isInterleaved ? (attribute as InterleavedBufferAttribute).offset : 0;
  const array = new (from.constructor as Float32ArrayConstructor)(itemSize * source.length);
  for (let i = 0, at = 0; i < source.length; i++) {
    const start = stride * source[i] + offset;
    for (let c = 0; c < itemSize; c++) array[at++] = from[start + c];
  }
  return new BufferAttribute(array, itemSize, normalized);
}

/** Whether a geometry is the one that a mesh was baked with. */
export const fitsGeometry = (geometry: BufferGeometry, { sourceVertices }: LightmappedMesh): boolean =>
  geometry.getAttribute('position')?.count === sourceVertices && Object.keys(geometry.morphAttributes).length === 0;

/** A copy of a geometry with vertices split as the lightmap needs them, and the lightmap's texture coordinates. */
export function lightmappedGeometry(geometry: BufferGeometry, mesh: LightmappedMesh, channel: number): BufferGeometry {
  const made = new BufferGeometry();
  made.name = geometry.name;
  for (const [name, attribute] of Object.entries(geometry.attributes))
    made.setAttribute(name, gathered(attribute, mesh.sourceVertex));
  made.setAttribute(`uv${channel}`, new BufferAttribute(mesh.uv1, 2));
  const { index } = mesh;
  made.setIndex(new BufferAttribute(mesh.uv1.length <= 131_072 ? Uint16Array.from(index) : index, 1));
  for (const { start, count, materialIndex } of geometry.groups) made.addGroup(start, count, materialIndex);
  made.boundingBox = geometry.boundingBox?.clone() ?? null;
  made.boundingSphere = geometry.boundingSphere?.clone() ?? null;
  return made;
}
