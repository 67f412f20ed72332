import type { WebGLRenderer } from 'three';
import { builtinMicroShaders } from './builtin';
import { checkLiveEdit } from './checkLiveEdit';
import { MicroShaderRegistry } from './MicroShaderRegistry';
import { WebGLShaderCompiler } from './WebGLShaderCompiler';

/** The registry of one FarolRenderer, with the built-in microshaders as its parent. */
export function createRegistry(webgl: WebGLRenderer): MicroShaderRegistry {
  const builtin = new MicroShaderRegistry();
  builtin.add(builtinMicroShaders);
  const compiler = new WebGLShaderCompiler(webgl.getContext() as WebGL2RenderingContext);
  const registry = new MicroShaderRegistry(builtin, { compiler });
  registry.addCheck((names) => checkLiveEdit(webgl, registry, names));
  return registry;
}
