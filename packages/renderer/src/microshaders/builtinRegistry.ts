import { MicroShaderRegistry } from './MicroShaderRegistry';
import { parseMicroShader } from './parseMicroShader';

/** Parent of the registries of all renderers of a page. */
export const builtinRegistry = new MicroShaderRegistry();

/** Adds microshaders to `builtinRegistry`, by name, except those that other late code has added. */
export function addBuiltinMicroShaders(sources: Readonly<Record<string, string>>): void {
  for (const [name, text] of Object.entries(sources))
    if (!builtinRegistry.has(name)) builtinRegistry.add(parseMicroShader(name, text));
}
