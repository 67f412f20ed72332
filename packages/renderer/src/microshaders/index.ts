// Microshaders without the passes of '@farol/renderer/authoring', for tools that show or check them.
export { explainCompileError, type MicroShaderCompileEntry } from './explainCompileError';
export { formatMicroShader } from './formatMicroShader';
export type { MicroShader, MicroShaderStage } from './MicroShader';
export { MicroShaderCompileError } from './MicroShaderCompileError';
export { MicroShaderRegistry, type MicroShaderListener, type MicroShaderRegistryOptions } from './MicroShaderRegistry';
export { parseMicroShader } from './parseMicroShader';
export type { MicroShaderCompiler, Shader, ShaderSource } from './Shader';
export { WebGLShaderCompiler } from './WebGLShaderCompiler';
