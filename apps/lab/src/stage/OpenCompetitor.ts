import type { Counters } from '@farol/tools/benchCounters';
import type { Competitor, Drawing } from '../competitors/Competitor';
import { GpuTimer } from '../measure/GpuTimer';
import { measureTurn } from '../measure/measureTurn';
import { median } from '../measure/spread';
import { nextTask } from '../measure/nextTask';
import { readPicture } from '../measure/readPicture';
import { waitForPixel } from '../measure/waitForPixel';
import type { Change, Counts, PassTimes } from '../results/LabRun';
import { isSoftware } from '../words/device';
import { deviceLimits } from './deviceLimits';
import { loseContext } from './loseContext';
import type { Opened, Turn } from './Stage';
import type { OwnedScene } from './StageScenes';

/** Time between two frames of the scene (s). */
const STEP = 1 / 60;
/** Time at which pictures are compared (s). */
const PICTURE_TIME = 1;
/** Longest wait for a competitor that draws with a substitute technique while its programs compile (ms). */
const SETTLING = 1500;
/** Number of frames whose passes are timed. */
const TIMED = 9;
/** Number of frames drawn before the first times of passes arrive. */
const BEFORE_TIMES = 12;
/** Number of lights added for the frame after a change of the lights. */
const ADDED = 10;

/** A competitor opened for one case of a run, with its canvas and its scene. */
export class OpenCompetitor {
  private drawn = 0;
  private timer: GpuTimer | null | undefined;

  constructor(
    private readonly competitor: Competitor,
    private readonly canvas: HTMLCanvasElement,
    private readonly scene: OwnedScene,
    private readonly drawing: Drawing,
    private readonly counters: Counters,
  ) {}

  /** Draws the first frame, timed, and the picture to be compared. */
  async drawFirst(signal: AbortSignal): Promise<Opened> {
    const { drawing, scene } = this;
    scene.setTime(0);
    await nextTask();
    signal.throwIfAborted();
    const begin = performance.now();
    drawing.lightsMoved?.();
    if (drawing.drawFirst) await drawing.drawFirst();
    else drawing.render();
    await this.finish();
    const firstMs = performance.now() - begin;
    this.check();
    await this.settle(signal);
    scene.setTime(PICTURE_TIME);
    drawing.lightsMoved?.();
    drawing.render();
    // the picture is read in the same task, since a WebGPU canvas is empty in the next one
    const picture = readPicture((await drawing.readPicture?.()) ?? this.canvas);
    await this.finish();
    this.check();
    const { name = null, reason = null } = drawing.technique?.() ?? {};
    return { firstMs, dropped: drawing.dropped?.() ?? 0, technique: name, reason, picture };
  }

  /** Measures frames for about `ms` milliseconds. */
  async turn(ms: number): Promise<Turn> {
    const { drawing } = this;
    // a software rasteriser gets no timer, since its timer queries count the work of other threads
    if (this.timer === undefined) {
      this.timer = drawing.gl && !isSoftware(deviceLimits().renderer) ? GpuTimer.of(drawing.gl) : null;
    }
    const turn = await measureTurn(
      { frame: this.frame, finish: this.finish, timer: this.timer, now: () => performance.now() },
      ms,
    );
    this.check();
    return turn;
  }

  count(): Counts {
    const { drawing, counters } = this;
    const targetBytes = drawing.targetBytes?.() ?? null;
    const { gl } = drawing;
    if (!gl) return { draws: null, triangles: null, programs: null, targetBytes, uploadBytes: null };
    const { draws, triangles, uploadBytes } = counters.count(this.frame);
    this.check();
    const counted = { draws, triangles: Math.round(triangles), targetBytes, uploadBytes };
    return { ...counted, programs: counters.programsOf(gl) };
  }

  /** Medians of the passes' times over some frames; null if the competitor has none. */
  async passes(): Promise<PassTimes | null> {
    const { drawing } = this;
    if (!drawing.passes || !drawing.setPassTimes) return null;
    drawing.setPassTimes(true);
    const times = new Map<string, { gpu: number[]; cpu: number[] }>();
    for (let i = 0; i < BEFORE_TIMES + TIMED; i++) {
      this.frame();
      await this.finish();
      await nextTask();
      const timed = i < BEFORE_TIMES ? null : drawing.passes();
      for (const { name, ms } of timed?.passes ?? []) {
        const list = times.get(name) ?? { gpu: [], cpu: [] };
        times.set(name, list);
        if (timed) list[timed.kind].push(ms);
      }
    }
    drawing.setPassTimes(false);
    this.check();
    const lists = [...times];
    if (lists.length === 0) return null;
    const kind = lists.some(([, { gpu }]) => gpu.length > 0) ? 'gpu' : 'cpu';
    const passes = lists.map(([name, list]) => ({ name, ms: list[kind].length > 0 ? median(list[kind]) : 0 }));
    return { kind, passes };
  }

  async addLights(): Promise<Change> {
    const { scene, drawing } = this;
    let remove: (() => void) | null = null;
    try {
      return await this.change(() => {
        remove = scene.addLights(ADDED);
        drawing.lightsChanged?.();
      });
    } finally {
      (remove as (() => void) | null)?.();
      drawing.lightsChanged?.();
    }
  }

  /** Measures the frame after a change to another technique and back; null if there is no other one. */
  async changeTechnique(): Promise<Change | null> {
    const { drawing } = this;
    if (!drawing.leaveTechnique) return null;
    const comeBack = drawing.leaveTechnique();
    try {
      this.frame();
      await this.finish();
    } catch (error) {
      comeBack();
      throw error;
    }
    return this.change(comeBack);
  }

  close(): void {
    const { drawing, scene } = this;
    this.timer?.dispose();
    drawing.dispose();
    scene.dispose();
    if (drawing.gl) loseContext(drawing.gl);
    this.canvas.width = this.canvas.height = 1;
  }

  /** Moves the lights by one time step, STEP, and draws. @returns duration of the drawing call (ms) */
  private readonly frame = (): number => {
    const { drawing } = this;
    this.scene.setTime(++this.drawn * STEP);
    const begin = performance.now();
    drawing.lightsMoved?.();
    drawing.render();
    return performance.now() - begin;
  };

  private readonly finish = (): void | Promise<void> => {
    const { drawing } = this;
    if (drawing.finish) return drawing.finish();
    if (drawing.gl) waitForPixel(drawing.gl);
  };

  /** Draws until the competitor uses the technique of its choice. */
  private async settle(signal: AbortSignal): Promise<void> {
    const { drawing } = this;
    if (!drawing.isSettled) return;
    const end = performance.now() + SETTLING;
    while (!drawing.isSettled() && performance.now() < end) {
      this.frame();
      await this.finish();
      await nextTask();
      signal.throwIfAborted();
    }
  }

  /** Measures the frame after a change. */
  private async change(change: () => void): Promise<Change> {
    const { gl } = this.drawing;
    const { counters } = this;
    this.frame();
    await this.finish();
    await nextTask();
    const programs = gl && counters.programsOf(gl);
    const begin = performance.now();
    change();
    this.frame();
    await this.finish();
    const ms = performance.now() - begin;
    this.check();
    return { ms, programs: gl && programs !== null ? counters.programsOf(gl) - programs : null };
  }

  /** Checks for errors. @throws Error when the context is lost, a shader does not compile or WebGL has an error */
  private check(): void {
    const { competitor, drawing } = this;
    drawing.check?.();
    const { gl } = drawing;
    if (!gl) return;
    if (gl.isContextLost()) {
      throw new Error(
        `${competitor.label}: the browser took its WebGL context away. Close other tabs, or choose fewer competitors.`,
      );
    }
    const error = gl.getError();
    if (error !== 0)
      throw new Error(`${competitor.label}: WebGL error 0x${error.toString(16)} (${errorNames[error]}).`);
  }
}

const errorNames: Readonly<Record<number, string>> = {
  0x500: 'invalid enum',
  0x501: 'invalid value',
  0x502: 'invalid operation',
  0x505: 'out of memory',
  0x506: 'invalid framebuffer operation',
};
