/** Whole sources for a compiler, composed of microshaders, without `#version`. */
export interface ShaderSource {
  readonly name: string;
  readonly vertexShader: string;
  readonly fragmentShader: string;
}

/** Compiles GPU programs from composed sources. */
export interface MicroShaderCompiler<Program> {
  /** @throws MicroShaderCompileError when the driver refuses it */
  compile(source: ShaderSource): Program;
  /** Frees a program that is no longer used. */
  release?(program: Program): void;
}

/** A shader of the registry. Live edits change its sources and program, not the object. */
export interface Shader<Program = WebGLProgram> extends ShaderSource {
  readonly vertexChunks: readonly string[];
  readonly fragmentChunks: readonly string[];
  /** Compiled program; null when the registry has no compiler. */
  readonly program: Program | null;
  /** Number of times that the shader was recomposed. */
  readonly revision: number;
}
