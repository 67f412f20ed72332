import type { WebGLRenderer } from 'three';
import type { FarolInfo, MemoryInfo, PassInfo } from './FarolInfo';
import type { LastFrame } from './LastFrame';
import type { GpuTimer } from './timer/GpuTimer';
import { fetching } from '../lights/fetching';
import { timerCode } from './lazyCode';
import type { Frame } from '../frame/Frame';
import type { ShadowMaps } from '../shadows/ShadowMaps';

const IDLE = { drawCalls: 0, triangles: 0, cpuMs: 0, gpuMs: null };

/** Fills `FarolInfo`: counts from the WebGLRenderer, CPU time from the clock, GPU time from queries read later. */
export class InfoRecorder {
  readonly info: FarolInfo;
  /** GPU timer; null until timing is on and its code is fetched. */
  private timer: GpuTimer | null = null;
  /** Passes by name, of each eye of an XR session. */
  private readonly eyes: Map<string, PassInfo>[] = [];
  private eye = 0;
  private timing = false;
  private started = 0;
  private passStarted = 0;
  private calls = 0;
  private triangles = 0;
  private pass: PassInfo | null = null;

  constructor(
    private readonly webgl: WebGLRenderer,
    last: LastFrame,
    /** Writes the bytes that Farol holds, by use, to `memory`, when the host reads them. Returns their sum. */
    count: (memory: MemoryInfo) => number,
  ) {
    const held = { gbuffer: 0, gbufferPixel: 0, targets: 0, lists: 0, shadows: 0, lights: 0, effects: 0 };
    this.info = {
      technique: '',
      reason: '',
      hint: null,
      get pending() {
        return last.pending;
      },
      passes: [],
      drawCalls: 0,
      triangles: 0,
      cpuMs: 0,
      gpuMs: null,
      budget: null,
      view: null,
      lights: { total: 0, visible: 0 },
      shadows: { drawn: 0, texels: 0, kept: 0, bounded: 0, bytes: 0 },
      programs: 0,
      quality: 'full',
      get memory() {
        count(held);
        return held;
      },
      get targetBytes() {
        return count(held);
      },
      uploadBytes: 0,
    };
    // registered before the host's own listeners, since these may draw a frame
    webgl.getContext().canvas.addEventListener('webglcontextrestored', this.restartTimer);
  }

  /** GPU timer of this frame's passes; null if they are not timed. */
  get passTimer(): GpuTimer | null {
    return this.timing ? this.timer : null;
  }

  /** @param eye - index of the eye that is drawn, 0 outside of XR sessions; counts add up over both eyes */
  begin(timing: boolean, eye: number): void {
    this.eye = eye;
    this.eyes[eye] ??= new Map();
    if (eye > 0) return;
    if (timing && this.timer === null) this.makeTimer();
    this.timing = timing && this.timer?.available === true;
    this.started = performance.now();
    this.info.passes.length = 0;
    this.info.drawCalls = this.info.triangles = 0;
    if (this.timing) this.timer!.poll();
  }

  /** Reads GPU times that have arrived since the last frame. @returns whether any had arrived */
  updateTimes(): boolean {
    if (!this.timing || !this.timer!.poll()) return false;
    for (const pass of this.info.passes) pass.gpuMs = this.timer!.times.get(pass.name) ?? null;
    this.sumTimes();
    return true;
  }

  /** @param isIdle - whether the pass draws nothing; it is then not timed. Default false */
  beginPass(name: string, isIdle = false): void {
    const known = this.eyes[this.eye];
    let pass = known.get(name);
    if (pass === undefined) {
      const label = this.eye > 0 ? `${name}, eye ${this.eye + 1}` : name;
      pass = { name: label, ...IDLE };
      known.set(name, pass);
    }
    this.info.passes.push(pass);
    if (isIdle) return void Object.assign(pass, IDLE);
    this.pass = pass;
    const { render } = this.webgl.info;
    this.calls = render.calls;
    this.triangles = render.triangles;
    if (this.timing) this.timer!.begin(pass.name);
    this.passStarted = performance.now();
  }

  endPass(): void {
    const { pass } = this;
    if (pass === null) return;
    pass.cpuMs = performance.now() - this.passStarted;
    if (this.timing) this.timer!.end();
    const { render } = this.webgl.info;
    pass.drawCalls = render.calls - this.calls;
    pass.triangles = render.triangles - this.triangles;
    this.info.drawCalls += pass.drawCalls;
    this.info.triangles += pass.triangles;
    pass.gpuMs = this.timing ? (this.timer!.times.get(pass.name) ?? null) : null;
    this.pass = null;
  }

  end(active: string, reason: string, { lights, uploadedBytes, isLite }: Frame, shadows: ShadowMaps | null): void {
    const { info } = this;
    info.technique = active;
    info.reason = reason;
    info.quality = isLite ? 'lite' : 'full';
    info.hint = fetching.reader?.hintFor(lights.singles) ?? null;
    this.sumTimes();
    info.lights.total = lights.total;
    info.lights.visible = lights.visible;
    info.shadows.drawn = shadows?.drawn ?? 0;
    info.shadows.texels = shadows?.texels ?? 0;
    info.shadows.kept = shadows?.kept ?? 0;
    info.shadows.bounded = shadows?.tiles.bounded ?? 0;
    info.shadows.bytes = shadows?.atlasBytes ?? 0;
    info.programs = this.webgl.info.programs?.length ?? 0;
    info.uploadBytes = (this.eye > 0 ? info.uploadBytes : 0) + lights.uploadedBytes + uploadedBytes;
    info.cpuMs = performance.now() - this.started;
  }

  dispose(): void {
    this.webgl.getContext().canvas.removeEventListener('webglcontextrestored', this.restartTimer);
    this.timer?.dispose();
    this.timer = null;
  }

  private readonly restartTimer = (): void => this.timer?.restart();

  private sumTimes(): void {
    const { info } = this;
    info.gpuMs = null;
    if (!this.timing) return;
    for (const { gpuMs } of info.passes) if (gpuMs !== null) info.gpuMs = (info.gpuMs ?? 0) + gpuMs;
  }

  private makeTimer(): void {
    const gl = this.webgl.getContext() as WebGL2RenderingContext;
    this.timer = timerCode.use(({ GpuTimer }) => new GpuTimer(gl));
  }
}
