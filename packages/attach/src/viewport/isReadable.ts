import type { BufferGeometry } from 'three';

/**
 * Whether the CPU can read a geometry's vertices: false for a `GLBufferAttribute`, and for arrays that the page freed
 * after upload.
 */
export function isReadable({ attributes, index }: BufferGeometry): boolean {
  const { position } = attributes;
  return [position, index].every((each) => !each || ('array' in each && each.array?.length > 0));
}
