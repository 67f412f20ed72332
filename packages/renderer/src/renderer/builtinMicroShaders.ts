import { MicroShaderRegistry } from '../microshaders/MicroShaderRegistry';
import { parseMicroShader } from '../microshaders/parseMicroShader';
import * as gbuffer from '../gbuffer/chunks';
import * as gpu from '../gpu/chunks';
import * as lighting from '../lighting/chunks';
import * as loops from '../lighting/loops/chunks';
import * as shading from '../lighting/shading/chunks';
import * as volumes from '../techniques/light-volumes/chunks';
import * as output from '../passes/output/chunks';

/** Sources in the core chunk, by name: a new microshader is a file, and a line in the `chunks.ts` of its folder. */
export const coreSources = { ...gbuffer, ...gpu, ...lighting, ...loops, ...shading, ...volumes, ...output };

/** Parent of the registries of all renderers. */
export const builtinRegistry = new MicroShaderRegistry();

/** Adds the microshaders of late code; several parts may add the same one. */
export function addBuiltinMicroShaders(sources: Readonly<Record<string, string>>): void {
  for (const [name, text] of Object.entries(sources))
    if (!builtinRegistry.has(name)) builtinRegistry.add(parseMicroShader(name, text));
}

addBuiltinMicroShaders(coreSources);
