import type { Matrix4, Vector3, WebGLRenderer } from 'three';

/** Number of floats of a matrix in the block: three rows of four. */
const FLOATS = 12;
/** Greatest number of matrices in a uniform block: 64 KiB, even if the device allows more. */
const MOST = 1365;

/** World matrices of shadow casters, in a uniform block. */
export class CasterMatrices {
  private readonly rows: Float32Array;
  private readonly gl: WebGL2RenderingContext;
  /** Last uniform binding point of the device: three uses points from the first on for the host's blocks. */
  private readonly point: number;
  private buffer: WebGLBuffer | null = null;
  private firstChanged = Infinity;
  private lastChanged = -1;

  constructor(webgl: WebGLRenderer) {
    this.gl = webgl.getContext() as WebGL2RenderingContext;
    this.point = (this.gl.getParameter(this.gl.MAX_UNIFORM_BUFFER_BINDINGS) as number) - 1;
    this.rows = new Float32Array(CasterMatrices.capacity(webgl) * FLOATS);
  }

  /** Number of objects that one block holds. */
  static capacity(webgl: WebGLRenderer): number {
    const gl = webgl.getContext() as WebGL2RenderingContext;
    const bytes = gl.getParameter(gl.MAX_UNIFORM_BLOCK_SIZE) as number;
    return Math.min(MOST, Math.floor(bytes / (FLOATS * Float32Array.BYTES_PER_ELEMENT)));
  }

  /** Sets the matrix of an object, relative to an origin (world space, m). */
  set(object: number, { elements: e }: Matrix4, { x, y, z }: Vector3): void {
    const { rows } = this;
    const at = object * FLOATS;
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 3; column++) rows[at + row * 4 + column] = e[column * 4 + row];
    }
    rows[at + 3] = e[12] - x;
    rows[at + 7] = e[13] - y;
    rows[at + 11] = e[14] - z;
    this.firstChanged = Math.min(this.firstChanged, at);
    this.lastChanged = Math.max(this.lastChanged, at + FLOATS);
  }

  /** Binds the matrix block of a program to the binding point that `bind` uses. */
  attach(program: WebGLProgram): void {
    const { gl } = this;
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, 'FarolCasters'), this.point);
  }

  /** Drops the uniform buffer, which was lost with the GL context. */
  lose(): void {
    this.buffer = null;
  }

  /** Uploads the matrices that have changed. */
  send(): void {
    const { gl, rows } = this;
    if (this.buffer === null) {
      this.buffer = gl.createBuffer();
      gl.bindBuffer(gl.UNIFORM_BUFFER, this.buffer);
      gl.bufferData(gl.UNIFORM_BUFFER, rows, gl.DYNAMIC_DRAW);
    } else if (this.lastChanged > this.firstChanged) {
      const { firstChanged: first, lastChanged: last } = this;
      gl.bindBuffer(gl.UNIFORM_BUFFER, this.buffer);
      gl.bufferSubData(gl.UNIFORM_BUFFER, first * Float32Array.BYTES_PER_ELEMENT, rows, first, last - first);
    }
    this.firstChanged = Infinity;
    this.lastChanged = -1;
  }

  bind(): void {
    this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER, this.point, this.buffer);
  }

  dispose(): void {
    this.gl.deleteBuffer(this.buffer);
    this.buffer = null;
  }
}
