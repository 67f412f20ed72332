import type { IUniform, Texture, Vector2, Vector4, WebGLRenderTarget } from 'three';
import type { UnprojectUniforms } from '../gpu/unprojectUniforms';
import type { RenderItem } from './RenderItem';

/** Uniforms of thinGBufferRead.glsl. */
export interface ThinGBufferUniforms extends UnprojectUniforms {
  farol_thinSurface: IUniform<Texture | null>;
  farol_thinDepth: IUniform<Texture | null>;
  farol_thinStored: IUniform<number>;
  /** Size of the thin G-buffer (texels). */
  farol_size: IUniform<Vector2>;
  /** Transform from the picture's normalised device coordinates to the buffer's, by `gridFit`. */
  farol_fit: IUniform<Vector4>;
}

/** Target that holds only those properties of surfaces that lighting needs. */
export interface ThinGBuffer {
  /**
   * Attachment 0: normal, specular lobe and object number; 1, if depth is too coarse for positions or shadow look-ups need
   * vertex normals: distances and vertex normals.
   */
  readonly target: WebGLRenderTarget;
  /** Side of the buffer as a share of the picture's. */
  readonly scale: number;
  /** Transform of the picture's normalised device coordinates to the buffer's, by `gridFit`. */
  readonly fit: Vector4;
  /** Opaque draws in the buffer; texels of the n-th hold `objectNumber(n)`. */
  readonly items: readonly RenderItem[];
  /** True for a transparent item whose layers are in the buffer. */
  isStippled(item: RenderItem): boolean;
}
