import { BufferGeometry } from 'three';
import type { Component } from './Component';

/** A component that makes the shape of its object: the ObjectRenderer draws that shape, not a mesh of its own. */
export interface ShapeSource {
  /** Geometry of the shape, the same object until the shape changes; null while there is none. */
  readonly shapeGeometry: BufferGeometry | null;
}

/** Geometry of the first enabled ShapeSource among an object's components; null without one. */
export function shapeOf(components: readonly Component[]): BufferGeometry | null {
  for (const each of components) {
    if (!each.enabled || !('shapeGeometry' in each)) continue;
    const { shapeGeometry } = each as Component & ShapeSource;
    if (shapeGeometry instanceof BufferGeometry) return shapeGeometry;
  }
  return null;
}
