import type { Camera } from 'three';
import { GpuTimer } from '../timer';
import type { BudgetController } from './BudgetController';

/** Maximum number of pending GPU timer queries. */
const FRAMES = 16;
/** Number of frames without a result of the GPU timer after which intervals count. */
const SILENT = 40;
/** Number of draws by other cameras in a row after which one of them counts as the camera that begins frames. */
const OTHERS = 32;

/**
 * Times frames of a host for a controller: by the GPU where it has a timer, else from one frame to the next. A frame begins when
 * the camera that began the last frame is drawn again: draws by other cameras are mirrors or further viewports of it.
 */
export class FrameClock {
  private timer: GpuTimer | null = null;
  /** The renderer's timer of passes, used in place of `timer` while it runs; null for none. */
  private passTimer: GpuTimer | null = null;
  private controller: BudgetController | null = null;
  private lead: WeakRef<Camera> | null = null;
  private otherCameraDraws = 0;
  /** Time at which the frame began (ms); -1 before the first. */
  private started = -1;
  private refreshes = 0;
  /** Whether `count` is requested for the display's next refresh. */
  private counts = false;
  private silent = 0;
  private frame = 0;
  private readonly scales = new Float64Array(FRAMES);
  /** Frame whose times are being added up; -1 for none. */
  private summed = -1;
  private sum = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {}

  /** Begins a draw. @param passTimer - timer that times the passes already; null for none */
  begin(camera: Camera, controller: BudgetController, passTimer: GpuTimer | null): void {
    if (this.leads(camera)) this.beginFrame(controller);
    this.timer ??= new GpuTimer(this.gl);
    this.passTimer = passTimer;
    this.controller = controller;
    const timer = passTimer ?? this.timer;
    timer.tag = this.frame;
    timer.onTime = this.addTime;
    if (passTimer !== null) return;
    timer.poll();
    timer.begin('frame');
  }

  /** Ends the draw. */
  end(): void {
    if (this.passTimer === null) this.timer?.end();
  }

  dispose(): void {
    this.timer?.dispose();
    if (this.passTimer !== null) this.passTimer.onTime = null;
    this.timer = this.passTimer = null;
    this.summed = this.started = -1;
  }

  private leads(camera: Camera): boolean {
    const lead = this.lead?.deref();
    if (lead !== camera && lead !== undefined && ++this.otherCameraDraws < OTHERS) return false;
    if (lead !== camera) this.lead = new WeakRef(camera);
    this.otherCameraDraws = 0;
    return true;
  }

  private beginFrame(controller: BudgetController): void {
    const now = performance.now();
    const isTimed = this.timer?.available === true && this.silent++ < SILENT;
    // several refreshes between two frames: the host draws on demand, and the interval tells nothing
    const isInterval = !isTimed && this.started >= 0 && this.refreshes < 2;
    if (isInterval) controller.add(this.scales[this.frame], now - this.started, 'interval');
    this.started = now;
    this.refreshes = 0;
    if (!this.counts) this.count();
    this.frame = (this.frame + 1) % FRAMES;
    this.scales[this.frame] = controller.advance();
  }

  /** Counts refreshes of the display since the frame began, up to two. */
  private readonly count = (): void => {
    this.counts = this.refreshes < 2 && this.started >= 0 && globalThis.requestAnimationFrame !== undefined;
    if (this.counts) requestAnimationFrame(this.refreshed);
  };

  private readonly refreshed = (): void => {
    this.refreshes++;
    this.count();
  };

  /** Adds up the GPU times of a frame's draws; they arrive in order. */
  private readonly addTime = (frame: number, ms: number): void => {
    this.silent = 0;
    if (frame !== this.summed) {
      if (this.summed >= 0) this.controller?.add(this.scales[this.summed], this.sum, 'gpu');
      this.summed = frame;
      this.sum = 0;
    }
    this.sum += ms;
  };
}
