import { MicroShaderRegistry } from './MicroShaderRegistry';
import { parseMicroShader } from './parseMicroShader';

/** Parent of the registries of all renderers of a page. */
export const builtinRegistry = new MicroShaderRegistry();

/** Adds microshaders to it, by name; one that it has already stays, since several parts of the code may bring it. */
export function addBuiltinMicroShaders(sources: Readonly<Record<string, string>>): void {
  for (const [name, text] of Object.entries(sources))
    if (!builtinRegistry.has(name)) builtinRegistry.add(parseMicroShader(name, text));
}
