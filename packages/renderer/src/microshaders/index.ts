export { MicroShaderRegistry } from './MicroShaderRegistry';
export type { MicroShader } from './MicroShader';
