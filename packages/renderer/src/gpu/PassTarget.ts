import { DepthTexture, FloatType, NearestFilter, WebGLRenderTarget, type RenderTargetOptions } from 'three';
import { fitTarget } from './fitTarget';
import { targetBytes } from './targetBytes';

/** Options of the constructor of PassTarget. */
export interface PassTargetOptions extends Omit<RenderTargetOptions, 'depthTexture'> {
  /** Whether depth is a texture of 32-bit floats, to be read by later passes. Default false: no depth at all. */
  readonly depthTexture?: boolean;
}

/** A render target of a pass, created and sized by `of`; with nearest filters by default. */
export class PassTarget {
  private made: WebGLRenderTarget | null = null;

  constructor(private readonly options: PassTargetOptions = {}) {}

  /** Bytes of the target on the GPU, computed from its formats. */
  get bytes(): number {
    return this.made === null ? 0 : targetBytes(this.made);
  }

  /** The target of the last call of `of`; null before the first. */
  get current(): WebGLRenderTarget | null {
    return this.made;
  }

  /** Returns the target, resized to this size (texels). */
  of(width: number, height: number): WebGLRenderTarget {
    const target = (this.made ??= this.make());
    fitTarget(target, width, height);
    return target;
  }

  /** Frees the target; the next `of` makes a new one. */
  dispose(): void {
    this.made?.depthTexture?.dispose();
    this.made?.dispose();
    this.made = null;
  }

  private make(): WebGLRenderTarget {
    const { depthTexture = false, ...options } = this.options;
    return new WebGLRenderTarget(1, 1, {
      depthBuffer: depthTexture,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      ...options,
      ...(depthTexture && { depthTexture: new DepthTexture(1, 1, FloatType) }),
    });
  }
}
