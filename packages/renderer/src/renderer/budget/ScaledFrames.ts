import type { WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { FrameRedirect } from '../../frame/FrameRedirect';
import { targetSizes } from '../../gpu/fitTarget';
import { hasOutputBuffer } from '../../three/hasOutputBuffer';
import type { BudgetInfo, FrameBudget } from '../FrameBudget';
import type { GpuTimer } from '../timer/GpuTimer';
import { BudgetController } from './BudgetController';
import { Enlargement } from './Enlargement';
import { FrameClock } from './FrameClock';
import { WHOLE } from './reasons';

/** Minimum side of a picture that is scaled (pixels). */
const SMALLEST = 32;

/**
 * Draws frames at the scale that holds a frame budget, into a part of a target made for the largest scale, and enlarges them to
 * the host's target.
 */
export class ScaledFrames {
  readonly info: BudgetInfo = { scale: 1, reason: '', ms: null, source: 'interval' };
  private controller: BudgetController | null = null;
  private readonly clock: FrameClock;
  private readonly enlargement = new Enlargement();
  private readonly small = new FrameRedirect('Farol scaled picture', true);
  private target: WebGLRenderTarget | null = null;
  /** Whether three draws to an output buffer in place of the canvas; null until tested. */
  private buffered: boolean | null = null;

  constructor(frame: Frame) {
    this.clock = new FrameClock(frame.gl);
  }

  get bytes(): number {
    return this.small.bytes + this.enlargement.bytes;
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
    if (info.scale < 1 && this.target !== null) {
      const width = Math.max(1, Math.round(frame.width * info.scale));
      const height = Math.max(1, Math.round(frame.height * info.scale));
      frame.ownsPart = true;
      this.small.begin(frame, this.target, width, height);
    } else this.target = null;
  }

  /** Enlarges the picture to the host's target, if it was redirected. Called inside three's `render`. */
  enlarge(frame: Frame): void {
    const { target } = this;
    if (target === null) return;
    this.target = null;
    if (target.samples > 0) frame.resolve(target);
    const { replaces } = this.small;
    this.small.end(frame);
    frame.ownsPart = false;
    frame.bindTarget();
    if (replaces && frame.webgl.autoClearStencil) frame.webgl.clear(false, false, true);
    this.enlargement.draw(frame, target, this.controller!.budget.sharpness, replaces);
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
    this.small.dispose();
  }

  /** Reason why a target is drawn at full size; null if it can be scaled. */
  private wholeReason({ target, level, several, width, height, webgl }: Frame): string | null {
    if (target === null && (this.buffered ??= hasOutputBuffer(webgl))) return WHOLE.buffered;
    if (several) return WHOLE.several;
    if (target !== null && (level > 0 || 'isWebGLCubeRenderTarget' in target || target.depth > 1)) return WHOLE.part;
    return Math.min(width, height) < SMALLEST ? WHOLE.small : null;
  }

  /** Target of the host's target's kind, sized for the largest scale. */
  private targetFor(frame: Frame, max: number): WebGLRenderTarget {
    const target = this.small.targetFor(frame);
    const width = Math.ceil(frame.width * max);
    const height = Math.ceil(frame.height * max);
    if (target.width < width || target.height < height)
      target.setSize(Math.max(target.width, width), Math.max(target.height, height));
    frame.webgl.initRenderTarget(target);
    return target;
  }
}
