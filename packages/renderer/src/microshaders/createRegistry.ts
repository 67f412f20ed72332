import type { WebGLRenderer } from 'three';
import { builtinMicroShaders } from './builtin';
import { MicroShaderRegistry } from './MicroShaderRegistry';

/** The registry of one FarolRenderer, with the built-in microshaders as its parent. */
export function createRegistry(_webgl: WebGLRenderer): MicroShaderRegistry {
  const builtin = new MicroShaderRegistry();
  for (const chunk of builtinMicroShaders) builtin.add(chunk);
  return new MicroShaderRegistry(builtin);
}
