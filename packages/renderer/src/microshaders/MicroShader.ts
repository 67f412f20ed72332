/** Shader stages that may include a microshader. */
export type MicroShaderStage = 'vertex' | 'fragment' | 'both';

/**
 * A piece of a shader: a header (uniforms, varyings, functions) and statements of `main()`.
 * @see thesis 3.1.2
 */
export interface MicroShader {
  /** Name, of letters, digits and `_ - . /`. */
  readonly name: string;
  /** GLSL inserted once before `main()`; its `#include "name"` lines are dependencies. */
  readonly header: string;
  /** Statements that the chunk adds to `main()`; '' for none. */
  readonly main: string;
  /** Shader stage that may include the chunk. Default 'both'. */
  readonly stage?: MicroShaderStage;
  /** Chunks whose headers must come before this one's, besides those that the header includes. */
  readonly dependencies: readonly string[];
  /** Line of the chunk's file (from 1) at which the header starts, for errors. Default 1. */
  readonly headerLine?: number;
  /** Line of the chunk's file (from 1) at which the main part starts, for errors. Default 1. */
  readonly mainLine?: number;
}
