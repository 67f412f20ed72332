import { type BufferGeometry, Vector3 } from 'three';

/** Scales a geometry, in place, to a longest side of `size` metres, centred in x and z and standing on y = 0. */
export function fitGeometry(geometry: BufferGeometry, size = 1): BufferGeometry {
  geometry.computeBoundingBox();
  const box = geometry.boundingBox!;
  const extent = box.getSize(new Vector3());
  const longest = Math.max(extent.x, extent.y, extent.z);
  const centre = box.getCenter(new Vector3());
  geometry.translate(-centre.x, -box.min.y, -centre.z);
  if (longest > 0) geometry.scale(size / longest, size / longest, size / longest);
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  return geometry;
}
