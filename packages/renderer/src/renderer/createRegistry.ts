import type { WebGLRenderer } from 'three';
import { coreSources } from './coreSources';
import { addBuiltinMicroShaders, builtinRegistry } from '../microshaders/builtinRegistry';
import { MicroShaderRegistry } from '../microshaders/MicroShaderRegistry';
import { WebGLShaderCompiler } from '../microshaders/WebGLShaderCompiler';
import { checkLiveEdit } from '../three/checkLiveEdit';

/** The registry of one FarolRenderer, with the built-in microshaders as its parent. */
export function createRegistry(webgl: WebGLRenderer): MicroShaderRegistry {
  addBuiltinMicroShaders(coreSources);
  const compiler = new WebGLShaderCompiler(webgl.getContext() as WebGL2RenderingContext);
  const registry = new MicroShaderRegistry(builtinRegistry, { compiler });
  registry.addCheck((names) => checkLiveEdit(webgl, registry, names));
  return registry;
}
