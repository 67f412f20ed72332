import { ShaderChunk } from 'three';
import { MicroShaderCompileError } from './MicroShaderCompileError';
import type { MicroShaderCompiler, ShaderSource } from './Shader';

const PRECISION = 'precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n';
/** Defines of the GLSL 1 names that three's shaders may use. */
const PREFIX = {
  vertex: `#version 300 es\n${PRECISION}#define attribute in\n#define varying out\n#define texture2D texture\n`,
  fragment: `#version 300 es\n${PRECISION}#define varying in\n#define texture2D texture\n#define textureCube texture\n`,
};
const FRAGMENT_COLOR = 'layout(location = 0) out highp vec4 farol_fragColor;\n#define gl_FragColor farol_fragColor\n';
const THREE_INCLUDE = /^[ \t]*#include +<([\w./]+)>/gm;

/**
 * Compiles and links composed sources on a WebGL 2 context, without changing its state. Sources are GLSL ES 3.00 without
 * `#version`; the GLSL 1 words `attribute`, `varying`, `texture2D` and `gl_FragColor` work too, and so do three's chunks.
 */
export class WebGLShaderCompiler implements MicroShaderCompiler<WebGLProgram> {
  constructor(private readonly gl: WebGL2RenderingContext) {}

  /** @throws MicroShaderCompileError when the driver refuses the source; Error when the context is lost */
  compile(source: ShaderSource): WebGLProgram {
    const { gl } = this;
    const program = gl.createProgram();
    const shaders: WebGLShader[] = [];
    try {
      for (const stage of ['vertex', 'fragment'] as const) {
        const shader = this.compileStage(source, stage);
        shaders.push(shader);
        gl.attachShader(program, shader);
      }
      gl.linkProgram(program);
      if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        throw new MicroShaderCompileError(source.name, 'link', gl.getProgramInfoLog(program) ?? '', '');
      }
      return program;
    } catch (error) {
      gl.deleteProgram(program);
      throw error;
    } finally {
      for (const shader of shaders) gl.deleteShader(shader);
    }
  }

  release(program: WebGLProgram): void {
    this.gl.deleteProgram(program);
  }

  private compileStage(source: ShaderSource, stage: 'vertex' | 'fragment'): WebGLShader {
    const { gl } = this;
    const text = withPrefix(source[`${stage}Shader`], stage);
    const shader = gl.createShader(stage === 'vertex' ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
    if (shader === null)
      throw new Error(
        `Shader "${source.name}" cannot compile while the WebGL context is lost; wait until it is restored.`,
      );
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return shader;
    const log = gl.getShaderInfoLog(shader) ?? '';
    gl.deleteShader(shader);
    throw new MicroShaderCompileError(source.name, stage, log, text);
  }
}

function withPrefix(source: string, stage: 'vertex' | 'fragment'): string {
  const text = withThreeChunks(source);
  return PREFIX[stage] + (stage === 'fragment' && text.includes('gl_FragColor') ? FRAGMENT_COLOR : '') + text;
}

function withThreeChunks(source: string): string {
  return source.replace(THREE_INCLUDE, (_, name: string) => {
    if (!Object.hasOwn(ShaderChunk, name))
      throw new Error(`#include <${name}>: three has no such shader chunk; check its name.`);
    return withThreeChunks(ShaderChunk[name as keyof typeof ShaderChunk]);
  });
}
