import { type Camera, Matrix4 } from 'three';

/**
 * Live stand-in for a camera that sees only a square of its picture, pixel by pixel.
 * @param x - left pixel of the square
 * @param y - lower pixel of the square
 * @param side - side of the square (pixels)
 * @param width - width of the picture (pixels)
 * @param height - height of the picture (pixels)
 */
export function windowCamera(
  camera: Camera,
  x: number,
  y: number,
  side: number,
  width: number,
  height: number,
): Camera {
  const window = Object.create(camera) as Camera;
  // scale and shift from the picture's normalised device coordinates to the square's
  const [sx, sy] = [width / side, height / side];
  const [dx, dy] = [sx - (2 * x) / side - 1, sy - (2 * y) / side - 1];
  const projection = new Matrix4(sx, 0, 0, dx, 0, sy, 0, dy, 0, 0, 1, 0, 0, 0, 0, 1).multiply(camera.projectionMatrix);
  const own = { writable: true, configurable: true };
  Object.defineProperty(window, 'projectionMatrix', { ...own, value: projection });
  Object.defineProperty(window, 'projectionMatrixInverse', { ...own, value: projection.clone().invert() });
  return window;
}
