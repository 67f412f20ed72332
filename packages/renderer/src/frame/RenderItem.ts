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
  /** Lit one light at a time by three. */
  lit: boolean;
  /** Shows shadows by three's getShadowMask(). */
  shadowMask: boolean;
  /** Other lights may reach it than most things, so that it is drawn forward. */
  layered: boolean;
  /** Drawn as opaque things are by default, so that any pass may draw it in its own order. */
  plain: boolean;
  /** Opaque, and to be drawn in three's order: its picture, or that of what comes after it, depends on it. */
  ordered: boolean;
  /** Plain, lit, and by three's own shader as it is, so that its shading may be shared out over passes. */
  splits: boolean;
  /** Its shader is not three's as it is. */
  ownShader: boolean;
  /** A technique's pass has drawn it this frame; the forward pass leaves it out. */
  drawn: boolean;
}
