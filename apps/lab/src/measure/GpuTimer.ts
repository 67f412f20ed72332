import { nextTask } from './nextTask';

/** EXT_disjoint_timer_query_webgl2, which TypeScript's library lacks. */
interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/** Longest wait for the GPU time of a frame (ms). */
const LONGEST = 5000;

export class GpuTimer {
  private readonly queries: WebGLQuery[] = [];

  private constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly extension: TimerExtension,
  ) {}

  /** A timer of a context; null if the device has no timer queries. */
  static of(gl: WebGL2RenderingContext): GpuTimer | null {
    const extension = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
    return extension && new GpuTimer(gl, extension);
  }

  /**
   * GPU times (ms) of consecutive frames: fewer than `count`, or none, if the device reports a disjoint clock, does not
   * answer in time, or answers with times longer than the whole measurement.
   */
  async time(count: number, frame: () => void): Promise<number[]> {
    const { gl, extension, queries } = this;
    while (queries.length < count) queries.push(gl.createQuery() as WebGLQuery);
    gl.getParameter(extension.GPU_DISJOINT_EXT); // the flag is read to clear it
    const begin = performance.now();
    for (let i = 0; i < count; i++) {
      gl.beginQuery(extension.TIME_ELAPSED_EXT, queries[i]);
      frame();
      gl.endQuery(extension.TIME_ELAPSED_EXT);
    }
    gl.flush();
    while (!this.isThere(queries[count - 1]) && performance.now() < begin + LONGEST && !gl.isContextLost())
      await nextTask();
    const whole = performance.now() - begin;
    if (gl.getParameter(extension.GPU_DISJOINT_EXT) as boolean) return [];
    const times: number[] = [];
    for (let i = 0; i < count; i++) {
      if (this.isThere(queries[i])) times.push((gl.getQueryParameter(queries[i], gl.QUERY_RESULT) as number) / 1e6);
    }
    return times.filter((ms) => ms <= whole);
  }

  dispose(): void {
    for (const query of this.queries.splice(0)) this.gl.deleteQuery(query);
  }

  private isThere(query: WebGLQuery): boolean {
    return this.gl.getQueryParameter(query, this.gl.QUERY_RESULT_AVAILABLE) as boolean;
  }
}
