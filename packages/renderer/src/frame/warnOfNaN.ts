import type { Object3D } from 'three';

const warned = new WeakSet<Object3D>();

/** Names an object once whose place in the picture is not a number. It is drawn as three draws it. */
export function warnOfNaN(object: Object3D): void {
  if (warned.has(object)) return;
  warned.add(object);
  console.warn(
    `Farol: ${object.type} "${object.name || object.uuid}" has a matrix or positions that are not numbers (NaN); set them. The rest is drawn.`,
  );
}
