import type { BufferGeometry, Material, Object3D } from 'three';

/** The range of a geometry that one material draws. */
export interface GeometryGroup {
  start: number;
  count: number;
  materialIndex?: number;
}

/** One draw as three's traversal gives it. Pooled: valid for the frame only. */
export interface RenderItem {
  id: number;
  object: Object3D;
  geometry: BufferGeometry;
  /** The host's material (or the scene's override). */
  material: Material;
  materialVariant: number;
  group: GeometryGroup | null;
  groupOrder: number;
  renderOrder: number;
  z: number;
  /** Its material is a node material: three itself draws it. */
  nodes: boolean;
  /** Whether three's lighting of the material goes light by light, so that Farol's loop can take its place. */
  lit: boolean;
  /** Whether the material shows shadows by three's getShadowMask(). */
  shadowMask: boolean;
  /** Whether the object's layers differ from most objects', so that other lights may reach it; drawn forward. */
  layered: boolean;
  /** Whether the item is drawn with default opaque state, so that passes may draw it in any order. */
  plain: boolean;
  /** Whether an opaque item must be drawn in three's order, since the picture depends on that. */
  ordered: boolean;
  /**
   * Whether the item is plain, lit, and has three's unchanged shader, so that several passes may share its shading.
   */
  splits: boolean;
  /** Whether the host has changed or replaced three's shader. */
  ownShader: boolean;
  /** Whether a technique's pass has drawn the item in this frame; the forward pass then skips it. */
  drawn: boolean;
}
