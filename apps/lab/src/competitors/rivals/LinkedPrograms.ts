import { firstLine } from '../createWebGL';

/** Checks the programs that a context links: if a program does not compile, its objects would be missing silently. */
export class LinkedPrograms {
  private readonly unchecked: WebGLProgram[] = [];

  constructor(private readonly gl: WebGL2RenderingContext) {
    const { linkProgram } = gl;
    gl.linkProgram = (program) => {
      linkProgram.call(gl, program);
      this.unchecked.push(program);
    };
  }

  /** Checks the programs. @throws Error with the first line of the compiler's log if a program did not compile */
  check(): void {
    const { gl } = this;
    for (const program of this.unchecked.splice(0)) {
      if (!gl.isProgram(program) || gl.getProgramParameter(program, gl.LINK_STATUS)) continue;
      const shaders = gl.getAttachedShaders(program) ?? [];
      const line = firstLine(gl.getProgramInfoLog(program), ...shaders.map((shader) => gl.getShaderInfoLog(shader)));
      throw new Error(`A shader does not compile on this device: ${line}`);
    }
  }
}
