import { BufferGeometry } from 'three';
import type { Component } from './Component';

/** A component that makes the shape of its object: the object's ObjectRenderer draws it in place of its mesh. */
export interface ShapeSource {
  /** Geometry of the shape, one object until the shape changes; null for none at present. */
  readonly shapeGeometry: BufferGeometry | null;
}

/** The geometry that an enabled component of an object makes; null where none does. */
export function shapeOf(components: readonly Component[]): BufferGeometry | null {
  for (const each of components) {
    if (!each.enabled || !('shapeGeometry' in each)) continue;
    const { shapeGeometry } = each as Component & ShapeSource;
    if (shapeGeometry instanceof BufferGeometry) return shapeGeometry;
  }
  return null;
}
