import type { BufferGeometry } from 'three';

/** False for vertices that the GPU alone has: of a `GLBufferAttribute`, or let go of by the page once three had sent them. */
export function isReadable({ attributes, index }: BufferGeometry): boolean {
  const { position } = attributes;
  return [position, index].every((each) => !each || ('array' in each && each.array?.length > 0));
}
