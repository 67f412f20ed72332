import { type Matrix4, Vector4 } from 'three';

const corner = new Vector4();

/**
 * Rectangle of pixels that a unit cube around the origin may cover: x, y, width, height, whole numbers. The whole picture if the
 * cube reaches behind the camera.
 * @param modelView - transform from the cube to view space (m)
 */
export function boxRectangle(
  modelView: Matrix4,
  projection: Matrix4,
  { width, height }: { readonly width: number; readonly height: number },
  rectangle: Vector4,
): Vector4 {
  let left = width;
  let right = 0;
  let bottom = height;
  let top = 0;
  for (let i = 0; i < 8; i++) {
    corner.set((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, (i >> 2) - 0.5, 1);
    corner.applyMatrix4(modelView).applyMatrix4(projection);
    if (corner.w <= 0) return rectangle.set(0, 0, width, height);
    const x = (corner.x / corner.w + 1) * 0.5 * width;
    const y = (corner.y / corner.w + 1) * 0.5 * height;
    left = Math.min(left, Math.floor(x));
    right = Math.max(right, Math.ceil(x));
    bottom = Math.min(bottom, Math.floor(y));
    top = Math.max(top, Math.ceil(y));
  }
  left = Math.max(left, 0);
  bottom = Math.max(bottom, 0);
  return rectangle.set(
    left,
    bottom,
    Math.max(Math.min(right, width) - left, 0),
    Math.max(Math.min(top, height) - bottom, 0),
  );
}
