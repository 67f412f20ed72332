import type { Camera, Object3D } from 'three';

const warned = new WeakSet<Object3D>();

/**
 * Warns once of a camera whose position or projection is NaN, else of an object whose screen position is NaN. Does not change
 * drawing.
 */
export function warnOfNaN(camera: Camera, object: Object3D | null = null): void {
  const { elements } = camera.projectionMatrix;
  const sum = elements[0] + elements[5] + elements[10] + camera.matrixWorldInverse.elements[12];
  const lost = sum !== sum ? camera : object;
  if (lost === null || warned.has(lost)) return;
  warned.add(lost);
  console.warn(
    `Farol: ${lost.type} "${lost.name || lost.uuid}" has NaN in its matrix, positions, fov or aspect; set finite numbers.`,
  );
}
