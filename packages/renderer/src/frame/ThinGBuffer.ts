import type { Vector4, WebGLRenderTarget } from 'three';
import type { RenderItem } from './RenderItem';

/** G-buffer with only those surface properties that lights need. */
export interface ThinGBuffer {
  /** Attachment 0: normal, specular lobe and object; 1, where depth is too coarse for positions: distances. */
  readonly target: WebGLRenderTarget;
  /** Texels for each pixel of the picture, along a side. */
  readonly scale: number;
  /** Transform of the picture's normalised device coordinates to the buffer's, by `gridFit`. */
  readonly fit: Vector4;
  /** Opaque items in the buffer; the n-th has `objectNumber(n)`. */
  readonly items: readonly RenderItem[];
  /** True for a transparent item whose layers are in the buffer. */
  isStippled(item: RenderItem): boolean;
}
