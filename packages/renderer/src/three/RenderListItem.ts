import type { BufferGeometry, Material, Object3D } from 'three';

/** The range of a geometry that one material draws. */
export interface GeometryGroup {
  start: number;
  count: number;
  materialIndex?: number;
}

/** One draw in three's render lists. */
export interface RenderListItem {
  id: number;
  object: Object3D;
  geometry: BufferGeometry;
  material: Material;
  materialVariant: number;
  group: GeometryGroup | null;
  groupOrder: number;
  renderOrder: number;
  z: number;
}

/** Comparison of two draws, for `Array.sort`. */
export type RenderItemSort = (a: RenderListItem, b: RenderListItem) => number;
