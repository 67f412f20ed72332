import {
  type Color,
  ColorManagement,
  type ColorSpace,
  DepthFormat,
  DepthStencilFormat,
  DepthTexture,
  FloatType,
  HalfFloatType,
  NearestFilter,
  NoColorSpace,
  SRGBTransfer,
  UnsignedByteType,
  Vector4,
  WebGLRenderTarget,
} from 'three';
import { fitTarget } from '../gpu/fitTarget';
import { targetBytes } from '../gpu/targetBytes';
import { isDrawnAsCanvas, setDrawnAsCanvas } from '../three/drawnAsCanvas';
import type { Frame } from './Frame';

/** Whether a texture holds colours that are encoded for the display, not linear ones. */
export const isEncoded = (colorSpace: string): boolean =>
  ColorManagement.getTransfer(colorSpace as ColorSpace) === SRGBTransfer;

/**
 * Redirects a frame's draws to a target of Farol's own: drawn like the canvas, with three's tone mapping and encoding, or
 * like a host's render target of linear light; with depth as a texture.
 */
export class FrameRedirect {
  /** Whether the picture replaces the host's pixels; else it is blended over them. */
  replaces = true;
  /** Viewport of the host's target. */
  readonly viewport = new Vector4();
  /** One target for each kind of host's target. */
  private readonly targets: WebGLRenderTarget[] = [];
  private hostTarget: WebGLRenderTarget | null = null;
  private hostFace = 0;
  private hostLevel = 0;

  /**
   * @param name - of the targets' textures
   * @param isLikeHost - whether targets have the host's samples, and 8 bits a channel where the host's have them
   */
  constructor(
    private readonly name: string,
    private readonly isLikeHost: boolean,
  ) {}

  get bytes(): number {
    return this.targets.reduce((sum, target) => sum + targetBytes(target), 0);
  }

  /** Whether a target is one of these. */
  owns(target: WebGLRenderTarget | null): boolean {
    return target !== null && this.targets.includes(target);
  }

  /** Target of the kind of the host's. */
  targetFor({ webgl, gl, target: host, hostSamples }: Frame): WebGLRenderTarget {
    const { isLikeHost } = this;
    const asCanvas = host === null || isDrawnAsCanvas(host);
    const space = host === null ? webgl.outputColorSpace : asCanvas ? host.texture.colorSpace : NoColorSpace;
    // linear light needs more than 8 bits a channel
    const takes8Bits = isLikeHost && isEncoded(space) && (host === null || host.texture.type === UnsignedByteType);
    const type = takes8Bits ? UnsignedByteType : host?.texture.type === FloatType ? FloatType : HalfFloatType;
    const stencil = host === null ? gl.getContextAttributes()!.stencil! : host.stencilBuffer;
    const samples = isLikeHost ? hostSamples : 0;
    let target: WebGLRenderTarget | undefined;
    for (const one of this.targets) {
      const { texture, stencilBuffer } = one;
      const fits = texture.type === type && texture.colorSpace === space && stencilBuffer === stencil;
      if (fits && one.samples === samples) target = one;
    }
    if (target !== undefined) return target;
    const depthTexture = new DepthTexture(1, 1, FloatType);
    depthTexture.format = stencil ? DepthStencilFormat : DepthFormat;
    target = new WebGLRenderTarget(1, 1, {
      type,
      colorSpace: space as ColorSpace,
      // texels are fetched; devices without OES_texture_float_linear read black from a filtered 32-bit float texture
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      stencilBuffer: stencil,
      samples,
      depthTexture,
    });
    target.texture.name = this.name;
    // else three would choose SRGB8, and the device would encode colours that shaders have encoded already
    if (takes8Bits) target.texture.internalFormat = 'RGBA8';
    setDrawnAsCanvas(target, asCanvas);
    this.targets.push(target);
    return target;
  }

  /** Sends the frame's draws to a target of {@link targetFor}, at a size (pixels). */
  begin(frame: Frame, target: WebGLRenderTarget, width: number, height: number): void {
    this.hostTarget = frame.target;
    this.hostFace = frame.face;
    this.hostLevel = frame.level;
    this.viewport.copy(frame.viewport);
    fitTarget(target, width, height);
    frame.target = target;
    frame.face = frame.level = 0;
    frame.viewport.set(0, 0, width, height);
    frame.resize();
    frame.bindTarget();
    // three clears for a background that is a colour, even without `autoClear`
    this.replaces = frame.webgl.autoClear || (frame.scene.background as Color | null)?.isColor === true;
    if (!this.replaces) frame.clear(1, true);
  }

  /** Gives the frame the host's target again, not yet bound. */
  end(frame: Frame): void {
    frame.target = this.hostTarget;
    frame.face = this.hostFace;
    frame.level = this.hostLevel;
    frame.viewport.copy(this.viewport);
    frame.resize();
  }

  dispose(): void {
    for (const target of this.targets) {
      target.depthTexture?.dispose();
      target.dispose();
    }
    this.targets.length = 0;
  }
}
