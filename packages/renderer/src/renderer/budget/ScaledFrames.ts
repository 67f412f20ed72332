import {
  type Color,
  ColorManagement,
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
  type ColorSpace,
} from 'three';
import type { Frame } from '../../frame/Frame';
import { fitTarget, targetSizes } from '../../gpu/fitTarget';
import { targetBytes } from '../../gpu/targetBytes';
import { isDrawnAsCanvas, setDrawnAsCanvas } from '../../three/drawnAsCanvas';
import { hasOutputBuffer } from '../../three/hasOutputBuffer';
import type { BudgetInfo, FrameBudget } from '../FrameBudget';
import type { GpuTimer } from '../timer/GpuTimer';
import { BudgetController } from './BudgetController';
import { Enlargement } from './Enlargement';
import { FrameClock } from './FrameClock';
import { WHOLE } from './reasons';

/** Minimum side of a picture that is scaled (pixels). */
const SMALL = 32;

/**
 * Draws frames at the scale that holds a frame budget, into a part of a target made for the largest scale, and enlarges them to
 * the host's target.
 */
export class ScaledFrames {
  readonly info: BudgetInfo = { scale: 1, reason: '', ms: null, source: 'interval' };
  private controller: BudgetController | null = null;
  private readonly clock: FrameClock;
  private readonly enlargement = new Enlargement();
  /** Targets of the small picture, one for each kind of host's target: canvas, floats, stencil, samples. */
  private readonly targets: WebGLRenderTarget[] = [];
  private target: WebGLRenderTarget | null = null;
  private hostTarget: WebGLRenderTarget | null = null;
  private hostFace = 0;
  private hostLevel = 0;
  private readonly hostViewport = new Vector4();
  private replaces = true;
  /** Whether three draws to an output buffer in place of the canvas; null until tested. */
  private buffered: boolean | null = null;

  constructor(frame: Frame) {
    this.clock = new FrameClock(frame.gl);
  }

  get bytes(): number {
    return this.targets.reduce((sum, target) => sum + targetBytes(target), this.enlargement.bytes);
  }

  /** Redirects a frame to a smaller picture, if the budget asks for one. Called outside of three's `render`. */
  begin(frame: Frame, budget: Required<FrameBudget>, passTimer: GpuTimer | null): void {
    if (this.controller?.budget !== budget) {
      this.controller = new BudgetController(budget);
      this.clock.dispose();
    }
    const { controller } = this;
    frame.finer = null;
    this.clock.begin(frame.seenBy, controller, passTimer);
    const { info } = this;
    targetSizes.room = 1;
    const whole = this.wholeReason(frame);
    info.scale = whole === null ? controller.scale : 1;
    if (whole === null) targetSizes.room = budget.max / info.scale;
    info.reason = whole ?? controller.reason;
    info.ms = controller.ms;
    info.source = controller.source;
    this.target = whole === null ? this.targetFor(frame, budget.max) : null;
    if (info.scale < 1 && this.target !== null) this.redirect(frame, this.target, info.scale);
    else this.target = null;
  }

  /** Enlarges the picture to the host's target, if it was redirected. Called inside three's `render`. */
  enlarge(frame: Frame): void {
    const { target } = this;
    if (target === null) return;
    this.target = null;
    if (target.samples > 0) frame.resolve(target);
    frame.target = this.hostTarget;
    frame.face = this.hostFace;
    frame.level = this.hostLevel;
    frame.viewport.copy(this.hostViewport);
    frame.ownsPart = false;
    frame.resize();
    frame.bindTarget();
    if (this.replaces && frame.webgl.autoClearStencil) frame.webgl.clear(false, false, true);
    this.enlargement.draw(frame, target, this.controller!.budget.sharpness, this.replaces);
    frame.finer = null;
  }

  /** Ends a frame, also one that has failed. */
  end(frame: Frame): void {
    this.target = null;
    frame.ownsPart = false;
    this.clock.end();
  }

  dispose(): void {
    this.clock.dispose();
    this.enlargement.dispose();
    for (const target of this.targets) {
      target.depthTexture?.dispose();
      target.dispose();
    }
    this.targets.length = 0;
  }

  /** Reason why a target is drawn at full size; null if it can be scaled. */
  private wholeReason({ target, level, several, width, height, webgl }: Frame): string | null {
    if (target === null && (this.buffered ??= hasOutputBuffer(webgl))) return WHOLE.buffered;
    if (several) return WHOLE.several;
    if (target !== null && (level > 0 || 'isWebGLCubeRenderTarget' in target || target.depth > 1)) return WHOLE.part;
    return Math.min(width, height) < SMALL ? WHOLE.small : null;
  }

  private redirect(frame: Frame, target: WebGLRenderTarget, scale: number): void {
    const { webgl } = frame;
    this.hostTarget = frame.target;
    this.hostFace = frame.face;
    this.hostLevel = frame.level;
    this.hostViewport.copy(frame.viewport);
    const width = Math.max(1, Math.round(frame.width * scale));
    const height = Math.max(1, Math.round(frame.height * scale));
    fitTarget(target, width, height);
    frame.target = target;
    frame.face = frame.level = 0;
    frame.viewport.set(0, 0, width, height);
    frame.ownsPart = true;
    frame.resize();
    frame.bindTarget();
    // three clears for a background that is a colour, even without `autoClear`
    this.replaces = webgl.autoClear || (frame.scene.background as Color | null)?.isColor === true;
    if (!this.replaces) frame.clear(1, true);
  }

  /** Target of the host's target's kind, sized for the largest scale. */
  private targetFor(frame: Frame, max: number): WebGLRenderTarget {
    const { webgl, target: host, hostSamples: samples } = frame;
    const asCanvas = host === null || isDrawnAsCanvas(host);
    const space = (
      host === null ? webgl.outputColorSpace : asCanvas ? host.texture.colorSpace : NoColorSpace
    ) as ColorSpace;
    // linear light needs more than 8 bits a channel
    const eight =
      ColorManagement.getTransfer(space) === SRGBTransfer && (host === null || host.texture.type === UnsignedByteType);
    const type = eight ? UnsignedByteType : host?.texture.type === FloatType ? FloatType : HalfFloatType;
    const stencil = host === null ? frame.gl.getContextAttributes()!.stencil! : host.stencilBuffer;
    let target: WebGLRenderTarget | undefined;
    for (const one of this.targets) {
      const { texture, stencilBuffer } = one;
      const fits = texture.type === type && texture.colorSpace === space && stencilBuffer === stencil;
      if (fits && one.samples === samples) target = one;
    }
    if (target === undefined) {
      target = makeTarget(type, space, stencil, samples);
      setDrawnAsCanvas(target, asCanvas);
      this.targets.push(target);
    }
    const width = Math.ceil(frame.width * max);
    const height = Math.ceil(frame.height * max);
    if (target.width < width || target.height < height)
      target.setSize(Math.max(target.width, width), Math.max(target.height, height));
    webgl.initRenderTarget(target);
    return target;
  }
}

function makeTarget(
  type: typeof FloatType | typeof HalfFloatType | typeof UnsignedByteType,
  colorSpace: ColorSpace,
  stencilBuffer: boolean,
  samples: number,
): WebGLRenderTarget {
  const depthTexture = new DepthTexture(1, 1, FloatType);
  depthTexture.format = stencilBuffer ? DepthStencilFormat : DepthFormat;
  const target = new WebGLRenderTarget(1, 1, {
    type,
    colorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    stencilBuffer,
    samples,
    depthTexture,
  });
  target.texture.name = 'Farol scaled picture';
  // else three would choose SRGB8, and the device would encode colours that shaders have encoded already
  if (type === UnsignedByteType) target.texture.internalFormat = 'RGBA8';
  return target;
}
