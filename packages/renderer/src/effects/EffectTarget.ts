import { LinearFilter, WebGLRenderTarget, type RenderTargetOptions } from 'three';

/** A target of an effect, made when it is first asked for, without depth unless the options say so. */
export class EffectTarget {
  private target: WebGLRenderTarget | null = null;

  /** @param bytesPerPixel of its colour, for the figures */
  constructor(
    private readonly options: RenderTargetOptions,
    private readonly bytesPerPixel: number,
  ) {}

  get bytes(): number {
    return this.target ? this.target.width * this.target.height * this.bytesPerPixel : 0;
  }

  /** The target with this size (pixels). */
  of(width: number, height: number): WebGLRenderTarget {
    this.target ??= new WebGLRenderTarget(1, 1, {
      depthBuffer: false,
      minFilter: LinearFilter,
      magFilter: LinearFilter,
      ...this.options,
    });
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    return this.target;
  }

  dispose(): void {
    this.target?.dispose();
    this.target = null;
  }
}
