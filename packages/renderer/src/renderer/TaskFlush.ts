/** Up to this many draws and lights, a frame is not worth `gl.flush()`. */
const FEW = 16;

/**
 * Lets the GPU begin a frame while the host makes the next one of the same task. At the end of a task the browser itself hands
 * on what was drawn: a page that draws one frame a task makes no call to the GPU's process for it.
 */
export class TaskFlush {
  /** Whether a frame of this task has not been handed on. */
  private holds = false;

  constructor(private readonly gl: WebGLRenderingContextBase) {}

  /** Begins a frame: hands on the one before, if that is of the same task. */
  begin(): void {
    if (this.holds) this.gl.flush();
  }

  /** Ends a frame of so many draws or lights. */
  end(count: number): void {
    if (this.holds || count <= FEW) return;
    this.holds = true;
    queueMicrotask(this.release);
  }

  private readonly release = (): void => void (this.holds = false);
}
