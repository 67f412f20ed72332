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
  /** Transform of the picture's normalised device coordinates to the buffer's. */
  farol_fit: IUniform<Vector4>;
}

/** Target with the surfaces' properties that lighting needs, and no more. */
export interface ThinGBuffer {
  /**
   * Attachment 0: normal, specular lobe and object; 1, where depth is too coarse for positions, or shadow maps are looked
   * up along another normal: distances, and the vertices' normals.
   */
  readonly target: WebGLRenderTarget;
  /** Texels for each pixel of the picture, along a side. */
  readonly scale: number;
  /** Transform of the picture's normalised device coordinates to the buffer's, by `gridFit`. */
  readonly fit: Vector4;
  /** Opaque draws in the buffer; texels of the n-th hold `objectNumber(n)`. */
  readonly items: readonly RenderItem[];
  /** True for a transparent item whose layers are in the buffer. */
  isStippled(item: RenderItem): boolean;
}
