import {
  AlwaysDepth,
  ColorManagement,
  CustomBlending,
  DepthFormat,
  DepthStencilFormat,
  DepthTexture,
  FloatType,
  HalfFloatType,
  LessEqualDepth,
  NearestFilter,
  NoBlending,
  NoColorSpace,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SRGBTransfer,
  Vector2,
  Vector4,
  WebGLRenderTarget,
  type Color,
  type ColorSpace,
  type Texture,
} from 'three';
import { fitTarget } from '../gpu/fitTarget';
import type { Frame } from '../frame/Frame';
import { FullscreenPass } from '../gpu/FullscreenPass';
import { targetBytes } from '../gpu/targetBytes';
import picturePresent from './picturePresent.glsl?raw';
import displayTransfer from '../frame/displayTransfer.glsl?raw';
import { isDrawnAsCanvas, setDrawnAsCanvas } from '../three/drawnAsCanvas';

/** Picture of each renderer, keyed by the renderer's cache of twins (materials with Farol's programs). */
const pictures = new WeakMap<Frame['twins'], Picture>();

/**
 * The picture of a frame in a target of Farol's own, with depth as a texture, for effects that need the whole picture. `begin`
 * redirects all draws to it, with the host's target's output (for the canvas, tone mapped and encoded). When each effect that
 * called `begin` has called `end`, the picture is written to the host's target with its depth.
 */
export class Picture {
  /** Target that the frame draws to, from `begin` on. */
  target!: WebGLRenderTarget;
  /** Current picture: `target`'s texture, or the result of an effect. */
  texture!: Texture;
  /** Whether `texture` is encoded for the display (sRGB's transfer function), not linear. */
  encoded = false;
  private users = 0;
  private toDisplay = false;
  private clears = true;
  private readonly targets: WebGLRenderTarget[] = [];
  private hostTarget: WebGLRenderTarget | null = null;
  private hostFace = 0;
  private hostLevel = 0;
  private readonly hostViewport = new Vector4();
  private readonly present = new FullscreenPass({
    program: 'picture',
    fragment: 'picturePresent',
    microShaders: { displayTransfer, picturePresent },
    uniforms: {
      farol_picture: { value: null as Texture | null },
      farol_pictureDepth: { value: null as Texture | null },
      farol_offset: { value: new Vector2() },
      farol_encode: { value: false },
    },
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    depthTest: true,
    depthWrite: true,
  });

  /** The one picture of a renderer, shared by its effects. */
  static of(frame: Frame): Picture {
    let picture = pictures.get(frame.twins);
    if (picture === undefined) pictures.set(frame.twins, (picture = new Picture()));
    return picture;
  }

  get bytes(): number {
    let bytes = 0;
    for (const target of this.targets) bytes += targetBytes(target);
    return bytes;
  }

  /** Redirects the frame's draws to this picture. Each effect that calls `begin` calls `end` too. */
  begin(frame: Frame): void {
    if (frame.target !== null && this.targets.includes(frame.target)) {
      this.users++;
      return;
    }
    this.users = 1; // set to 1, not incremented: an exception in the last frame may have left some
    const { webgl } = frame;
    this.hostTarget = frame.target;
    this.hostFace = frame.face;
    this.hostLevel = frame.level;
    this.hostViewport.copy(frame.viewport);
    this.target = this.targetFor(frame);
    fitTarget(this.target, frame.width, frame.height);
    this.texture = this.target.texture;
    this.toDisplay = ColorManagement.getTransfer(this.target.texture.colorSpace as ColorSpace) === SRGBTransfer;
    this.encoded = this.toDisplay;
    frame.target = this.target;
    frame.face = frame.level = 0;
    frame.viewport.set(0, 0, frame.width, frame.height);
    frame.bindTarget();
    // three clears for a background that is a colour, even without `autoClear`
    this.clears = webgl.autoClear || (frame.scene.background as Color | null)?.isColor === true;
    if (!this.clears) frame.clear(1, true);
  }

  /**
   * Whether the rest of a frame can be drawn directly to the host's target: a single effect uses the picture, and a
   * pixel has the same coordinates in the picture and in the host's target.
   */
  get isAlone(): boolean {
    return this.users === 1 && this.hostViewport.x === 0 && this.hostViewport.y === 0;
  }

  /** Whether a single effect uses the picture at this point: its result is the finished picture. */
  get isLast(): boolean {
    return this.users === 1;
  }

  /**
   * Ends the use of the picture by an effect; the last effect to end writes the picture to the host's target.
   * @param goesOn - whether more of the frame is drawn to the host's target afterwards
   */
  end(frame: Frame, goesOn = false): void {
    if (--this.users > 0) return;
    const { webgl } = frame;
    frame.target = this.hostTarget;
    frame.face = this.hostFace;
    frame.level = this.hostLevel;
    frame.viewport.copy(this.hostViewport);
    const { uniforms } = this.present;
    uniforms.farol_picture.value = this.texture;
    uniforms.farol_pictureDepth.value = this.target.depthTexture;
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    uniforms.farol_encode.value = this.toDisplay && !this.encoded;
    const material = this.present.material(frame);
    // the picture replaces the host's earlier content where it was cleared, else it is blended over that content
    material.blending = this.clears ? NoBlending : CustomBlending;
    material.depthFunc = this.clears ? AlwaysDepth : LessEqualDepth;
    frame.bindTarget();
    // three has cleared the stencil of the picture's target only; the host's is cleared here
    if (goesOn && this.clears && webgl.autoClearStencil) webgl.clear(false, false, true);
    const samples = goesOn && frame.wantsSampleDepths;
    material.depthWrite = !samples;
    if (samples) frame.clear(0, true);
    this.present.draw(frame);
    if (samples) frame.drawSampleDepths();
  }

  /** Compiles the program that writes the picture to the host's target. */
  warmUp(frame: Frame): void {
    this.present.draw(frame);
  }

  dispose(): void {
    for (const target of this.targets) {
      target.depthTexture?.dispose();
      target.dispose();
    }
    this.targets.length = 0;
    this.present.dispose();
  }

  /** Target like the canvas, with three's tone mapping and encoding, or like a host's render target of linear light. */
  private targetFor(frame: Frame): WebGLRenderTarget {
    const { webgl, target: host } = frame;
    const type = host?.texture.type === FloatType ? FloatType : HalfFloatType;
    const asCanvas = host === null || isDrawnAsCanvas(host);
    const space = host === null ? webgl.outputColorSpace : asCanvas ? host.texture.colorSpace : NoColorSpace;
    const colorSpace = space as ColorSpace;
    const stencil = host === null ? frame.gl.getContextAttributes()!.stencil! : host.stencilBuffer;
    let target: WebGLRenderTarget | undefined;
    for (const one of this.targets) {
      const { texture, stencilBuffer } = one;
      if (texture.type === type && texture.colorSpace === colorSpace && stencilBuffer === stencil) target = one;
    }
    if (target === undefined) {
      target = new WebGLRenderTarget(1, 1, {
        type,
        colorSpace,
        // effects fetch texels; devices without OES_texture_float_linear read black from a filtered 32-bit float texture
        minFilter: NearestFilter,
        magFilter: NearestFilter,
        stencilBuffer: stencil,
        depthTexture: new DepthTexture(
          1,
          1,
          FloatType,
          undefined,
          undefined,
          undefined,
          undefined,
          undefined,
          undefined,
          stencil ? DepthStencilFormat : DepthFormat,
        ),
      });
      target.texture.name = 'Farol picture';
      if (asCanvas) setDrawnAsCanvas(target, true);
      this.targets.push(target);
    }
    return target;
  }
}
