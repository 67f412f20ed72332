import type { WebGLRenderer } from 'three';
import type { CasterMatrices } from './CasterMatrices';
import fragment from './placementFragment.glsl?raw';
import vertex from './placement.glsl?raw';

/** Numbers of a vertex before (own space and object) and after it is placed. */
const FROM = 4;
const TO = 3;
const BYTES = Float32Array.BYTES_PER_ELEMENT;

/**
 * Places vertices of many objects by the matrices of those, once for all shadow maps that show them: by transform feedback,
 * from one buffer into another. Six maps a point light read them some ten times a frame.
 * @see OpenGL ES 3.0 specification, 2.15 Transform Feedback
 */
export class CasterPlacement {
  private readonly gl: WebGL2RenderingContext;
  private program: WebGLProgram | null = null;
  private feedback: WebGLTransformFeedback | null = null;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly capacity: number,
  ) {
    this.gl = webgl.getContext() as WebGL2RenderingContext;
  }

  /** Forgets what the context has lost. */
  lose(): void {
    this.program = this.feedback = null;
  }

  /** Buffers for so many vertices. */
  makeBuffers(vertices: number): { from: WebGLBuffer; to: WebGLBuffer; array: WebGLVertexArrayObject } {
    const { gl } = this;
    const from = gl.createBuffer();
    const to = gl.createBuffer();
    const array = gl.createVertexArray();
    const before = gl.getParameter(gl.VERTEX_ARRAY_BINDING) as WebGLVertexArrayObject | null;
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, from);
    gl.bufferData(gl.ARRAY_BUFFER, vertices * FROM * BYTES, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, FROM, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(before);
    gl.bindBuffer(gl.ARRAY_BUFFER, to);
    gl.bufferData(gl.ARRAY_BUFFER, vertices * TO * BYTES, gl.DYNAMIC_COPY);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return { from, to, array };
  }

  /** Sends vertices to the first buffer: `FROM` numbers each. */
  send(from: WebGLBuffer, data: Float32Array, first: number, count: number): void {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, from);
    gl.bufferSubData(gl.ARRAY_BUFFER, first * FROM * BYTES, data, first * FROM, count * FROM);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
  }

  /** Places some vertices. Leaves three's state as it is, but for the program, of which it keeps track. */
  run(array: WebGLVertexArrayObject, to: WebGLBuffer, matrices: CasterMatrices, first: number, count: number): void {
    const { gl, webgl } = this;
    this.program ??= this.link(matrices);
    this.feedback ??= gl.createTransformFeedback();
    webgl.state.useProgram(this.program as never);
    matrices.bind();
    const before = gl.getParameter(gl.VERTEX_ARRAY_BINDING) as WebGLVertexArrayObject | null;
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, this.feedback);
    gl.bindBufferRange(gl.TRANSFORM_FEEDBACK_BUFFER, 0, to, first * TO * BYTES, count * TO * BYTES);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, first, count);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.bindVertexArray(before);
  }

  dispose(): void {
    this.gl.deleteProgram(this.program);
    this.gl.deleteTransformFeedback(this.feedback);
    this.lose();
  }

  private link(matrices: CasterMatrices): WebGLProgram {
    const { gl } = this;
    const program = gl.createProgram();
    const shaders = [this.compile(gl.VERTEX_SHADER, vertex), this.compile(gl.FRAGMENT_SHADER, fragment)];
    for (const shader of shaders) gl.attachShader(program, shader);
    gl.bindAttribLocation(program, 0, 'farol_corner');
    gl.transformFeedbackVaryings(program, ['farol_placed'], gl.INTERLEAVED_ATTRIBS);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      const log = shaders.map((shader) => gl.getShaderInfoLog(shader)).join('\n');
      throw new Error(
        `Farol: the program that places shadow casters does not link: ${gl.getProgramInfoLog(program)}\n${log}`,
      );
    }
    for (const shader of shaders) gl.deleteShader(shader);
    matrices.attach(program);
    return program;
  }

  private compile(type: number, text: string): WebGLShader {
    const shader = this.gl.createShader(type)!;
    this.gl.shaderSource(
      shader,
      `#version 300 es\n#define FAROL_CASTERS ${this.capacity}\nprecision highp float;\n${text}`,
    );
    this.gl.compileShader(shader);
    return shader;
  }
}
