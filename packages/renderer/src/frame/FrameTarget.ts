import { Vector2, Vector4, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { framebufferHandle, multisampledFramebufferHandle, textureHandle } from '../three/handles';
import {
  bindFramebuffer,
  bindTexture,
  isDepthReversed,
  setViewport,
  unbindTexture,
  unmaskColour,
  unmaskDepth,
} from '../three/state';

const TRANSPARENT = new Vector4(0, 0, 0, 0);
const size = new Vector2();
/** Arguments of `drawBuffers`, by the number of attachments. */
const drawBuffers: number[][] = [];
/** Argument of `clearBufferfv`. */
const clearColor = new Float32Array(4);
const farDepth = new Float32Array([1]);

/** The target of a host's frame, and methods to bind, clear and copy targets. */
export class FrameTarget {
  readonly gl: WebGL2RenderingContext;

  // ---- The host's target: set by `beginTarget`; an effect that takes the picture (`FarolEffect.takesPicture`) sets `target`,
  // `face` and `level` in `begin` or `picked`, and restores them in `end` ----

  /** The host's render target, null for the canvas. */
  target: WebGLRenderTarget | null = null;
  /** Cube face of the target. */
  face = 0;
  /** Mipmap level of the target. */
  level = 0;
  /** The part of the target that is drawn to: x, y, width, height (pixels). */
  readonly viewport = new Vector4();
  /** Width of the viewport (pixels), 1 at least. */
  width = 1;
  /** Height of the viewport (pixels), 1 at least. */
  height = 1;
  /** Samples a pixel of the host's target, also while an effect redirects the frame. */
  hostSamples = 0;
  /** Whether nothing of the target outside of the viewport is used, as with a frame budget's target. */
  ownsPart = false;
  /**
   * Finished picture with more texels than the frame has pixels (linear light), set by an effect's `end` if the frame is
   * enlarged afterwards; else null.
   */
  finer: WebGLRenderTarget | null = null;
  /** Whether the host's target has several textures; then no effect replaces the target. */
  several = false;
  /** Whether the canvas has depth, and no stencil. */
  private readonly canvasDepthOnly: boolean;
  private readonly canvasHasDepth: boolean;
  /** Whether the canvas's colours are multiplied by alpha. */
  readonly premultiplied: boolean;
  private readonly canvasSamples: number;

  constructor(readonly webgl: WebGLRenderer) {
    this.gl = webgl.getContext() as WebGL2RenderingContext;
    const attributes = this.gl.getContextAttributes();
    this.canvasHasDepth = attributes?.depth !== false;
    this.canvasDepthOnly = attributes?.stencil === false && this.canvasHasDepth;
    this.premultiplied = attributes?.premultipliedAlpha !== false;
    this.canvasSamples = attributes?.antialias ? 4 : 0;
  }

  /** Samples a pixel of the target: above 0 it is multisampled. */
  get samples(): number {
    return this.target === null ? this.canvasSamples : this.target.samples;
  }

  protected get hasDepth(): boolean {
    return this.target === null ? this.canvasHasDepth : this.target.depthBuffer;
  }

  /** Reads the host's current target and viewport. */
  protected beginTarget(): void {
    const { webgl } = this;
    this.target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    this.hostSamples = this.samples;
    this.face = webgl.getActiveCubeFace();
    this.level = webgl.getActiveMipmapLevel();
    this.several = this.target !== null && this.target.textures.length > 1;
    webgl.getCurrentViewport(this.viewport);
    this.resize();
  }

  /** Sets `target` to three's output buffer, if the WebGLRenderer was created with an `outputBufferType`. */
  takeOutputBuffer(): void {
    const { webgl } = this;
    if (this.target !== null) return;
    this.target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    if (this.target === null) return;
    webgl.getCurrentViewport(this.viewport);
    this.resize();
  }

  /** Sets width and height from the viewport, rounded down as WebGL does. */
  resize(): void {
    const { z, w } = this.viewport.roundToZero();
    this.width = Math.max(1, z);
    this.height = Math.max(1, w);
  }

  /**
   * True if a pass that writes every pixel of the viewport covers the whole target, which must have depth, one sample and no
   * stencil.
   */
  ownsTarget(): boolean {
    const { webgl, target, viewport } = this;
    if (this.level !== 0 || this.samples > 0 || isDepthReversed(webgl) || webgl.xr.isPresenting) return false;
    if (target === null) {
      webgl.getDrawingBufferSize(size);
      if (!this.canvasDepthOnly || webgl.getScissorTest()) return false;
    } else {
      size.set(target.width, target.height);
      if (!target.depthBuffer || target.stencilBuffer || target.scissorTest || target.textures.length > 1) return false;
    }
    if (this.ownsPart) return true;
    return viewport.x === 0 && viewport.y === 0 && viewport.z === size.x && viewport.w === size.y;
  }

  /** Draws to the host's target from here on. */
  bindTarget(): void {
    this.webgl.setRenderTarget(this.target, this.face, this.level);
    setViewport(this.webgl, this.viewport);
  }

  /** Draws to a target of Farol's own from here on. */
  bind(target: WebGLRenderTarget): void {
    this.webgl.setRenderTarget(target);
  }

  /** Clears attachments of the bound target to a value and its depth to the farthest, without touching the host's clear colour. */
  clear(attachments: number, depth: boolean, value: Vector4 = TRANSPARENT): void {
    const { gl, webgl } = this;
    unmaskColour(webgl);
    value.toArray(clearColor);
    for (let i = 0; i < attachments; i++) gl.clearBufferfv(gl.COLOR, i, clearColor);
    if (depth) {
      unmaskDepth(webgl);
      farDepth[0] = isDepthReversed(webgl) ? 0 : 1;
      gl.clearBufferfv(gl.DEPTH, 0, farDepth);
    }
  }

  /** Clears one attachment of the bound target to zeros. */
  clearOne(attachment: number): void {
    unmaskColour(this.webgl);
    TRANSPARENT.toArray(clearColor);
    this.gl.clearBufferfv(this.gl.COLOR, attachment, clearColor);
  }

  /** Draws only to the lower right quarter of the viewport from here on. */
  quarter(): void {
    const { viewport } = this;
    const width = Math.max(1, viewport.z >> 1);
    const height = Math.max(1, viewport.w >> 1);
    viewport.set(viewport.x + viewport.z - width, viewport.y, width, height);
    this.resize();
  }

  /** Resolves a multisampled target into its textures; depth takes one of the samples. */
  resolve(target: WebGLRenderTarget): void {
    const { gl, webgl } = this;
    this.copy(multisampledFramebufferHandle(webgl, target)!, target, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** Resolves three's transmission target, which is bound, into its texture and mipmaps again. */
  resolveTransmission(): void {
    const { gl, webgl } = this;
    const target = webgl.getRenderTarget() as WebGLRenderTarget;
    this.copy(multisampledFramebufferHandle(webgl, target)!, target, gl.COLOR_BUFFER_BIT);
    bindTexture(webgl, gl.TEXTURE_2D, textureHandle(webgl, target.texture)!);
    gl.generateMipmap(gl.TEXTURE_2D);
    unbindTexture(webgl);
  }

  /**
   * Copies depth to the whole of a target; both have a depth texture of the same format.
   * @param x - left pixel of the copied rectangle of `from`; y likewise
   */
  copyDepth(from: WebGLRenderTarget, to: WebGLRenderTarget, x = 0, y = 0): void {
    this.copy(framebufferHandle(this.webgl, from)!, to, this.gl.DEPTH_BUFFER_BIT, x, y);
  }

  /** @param x - left pixel of the copied rectangle of `from`; y likewise */
  private copy(from: WebGLFramebuffer, to: WebGLRenderTarget, bits: number, x = 0, y = 0): void {
    const { gl, webgl } = this;
    const { z: width, w: height } = to.viewport;
    const written = framebufferHandle(webgl, to)!;
    bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, from);
    bindFramebuffer(webgl, gl.DRAW_FRAMEBUFFER, written);
    gl.blitFramebuffer(x, y, x + width, y + height, 0, 0, width, height, bits, gl.NEAREST);
    bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, written);
  }

  /** Whether the host's target is bound and has several textures. */
  protected get drawsToSeveral(): boolean {
    return this.several && this.webgl.getRenderTarget() === this.target;
  }

  /** Draws only to the first `count` textures of the bound target; WebGL refuses a shader that writes fewer. */
  protected setDrawBuffers(count: number): void {
    const { gl } = this;
    gl.drawBuffers((drawBuffers[count] ??= Array.from({ length: count }, (_, i) => gl.COLOR_ATTACHMENT0 + i)));
  }
}
