import type { BufferGeometry, Material, Object3D } from 'three';

/** The range of a geometry that one material draws. */
export interface GeometryGroup {
  start: number;
  count: number;
  materialIndex?: number;
}

/** One draw as three's lists hold it. */
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

/** Order of two draws, as `Array.sort` takes it. */
export type RenderItemSort = (a: RenderListItem, b: RenderListItem) => number;
