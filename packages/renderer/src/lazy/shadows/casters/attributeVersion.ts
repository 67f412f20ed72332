import type { BufferAttribute, InterleavedBufferAttribute } from 'three';

/** The version of an attribute's data, which several interleaved ones share. */
export function attributeVersion(attribute: BufferAttribute | InterleavedBufferAttribute): number {
  const interleaved = attribute as InterleavedBufferAttribute;
  return interleaved.isInterleavedBufferAttribute ? interleaved.data.version : (attribute as BufferAttribute).version;
}
