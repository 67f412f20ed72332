interface Pending {
  readonly name: string;
  readonly query: WebGLQuery;
  readonly tag: number;
}

/** The extension's constants; lib.dom does not have them. */
interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/**
 * GPU time of named passes by EXT_disjoint_timer_query_webgl2, read frames later, so that nothing waits.
 * Does nothing where the extension is missing, or while the host times with a query of its own.
 */
export class GpuTimer {
  /** Last known GPU time of each pass (ms). */
  readonly times = new Map<string, number>();
  /** Number stored with times measured from now on, passed to `onTime`. */
  tag = 0;
  /** Called with each time as it arrives (ms, NaN if it was interrupted), in order, with its tag. */
  onTime: ((tag: number, ms: number) => void) | null = null;
  private extension: TimerExtension | null = null;
  private readonly pending: Pending[] = [];
  private readonly free: WebGLQuery[] = [];
  private running = false;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.restart();
  }

  get available(): boolean {
    return this.extension !== null;
  }

  begin(name: string): void {
    const { extension, gl } = this;
    if (extension === null || this.pending.length > 256) return;
    if (gl.getQuery(extension.TIME_ELAPSED_EXT, gl.CURRENT_QUERY) !== null) return;
    const query = this.free.pop() ?? gl.createQuery();
    gl.beginQuery(extension.TIME_ELAPSED_EXT, query);
    this.pending.push({ name, query, tag: this.tag });
    this.running = true;
  }

  end(): void {
    if (!this.running) return;
    this.gl.endQuery(this.extension!.TIME_ELAPSED_EXT);
    this.running = false;
  }

  /** Reads the results that have arrived. @returns whether there were any */
  poll(): boolean {
    const { gl, extension, pending } = this;
    if (extension === null || pending.length === 0) return false;
    const waiting = pending.length;
    const disjoint = gl.getParameter(extension.GPU_DISJOINT_EXT) as boolean;
    while (pending.length > 0 && gl.getQueryParameter(pending[0].query, gl.QUERY_RESULT_AVAILABLE)) {
      const { name, query, tag } = pending.shift()!;
      const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT) as number;
      if (!disjoint) this.times.set(name, nanoseconds / 1e6);
      this.onTime?.(tag, disjoint ? NaN : nanoseconds / 1e6);
      this.free.push(query);
    }
    return pending.length < waiting;
  }

  /** Restarts after a lost context: its queries are lost, and the extension must be read again. */
  restart(): void {
    this.pending.length = this.free.length = 0;
    this.running = false;
    this.extension = this.gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
  }

  dispose(): void {
    for (const { query } of this.pending) this.gl.deleteQuery(query);
    for (const query of this.free) this.gl.deleteQuery(query);
    this.pending.length = this.free.length = 0;
  }
}
