import type { RenderListItem } from '../three/RenderListItem';

/** One draw as three's traversal gives it, of the host's material (or the scene's override). Pooled: valid for the frame only. */
export interface RenderItem extends RenderListItem {
  /** Of a node material: three itself draws it. */
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
