/** Up to this many draws and lights, a frame is not worth `gl.flush()`. */
const FEW = 16;

/** Lets the GPU begin a frame while the host makes the next one of its task; the browser itself hands on a task's last frame. */
export class TaskFlush {
  private holds = false;

  constructor(private readonly gl: WebGLRenderingContextBase) {}

  begin(): void {
    if (this.holds) this.gl.flush();
  }

  /** Ends a frame of so many draws or lights. */
  end(count: number): void {
    if (!this.holds && count > FEW) queueMicrotask(this.release);
    this.holds ||= count > FEW;
  }

  private readonly release = (): void => void (this.holds = false);
}
