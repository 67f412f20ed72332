import type { MicroShaderRegistry } from './MicroShaderRegistry';
import { parseMicroShader } from './parseMicroShader';

/** Adds an effect's own chunks, by name, to a renderer's registry, unless they are there. */
export function addMicroShaders(registry: MicroShaderRegistry, sources: Record<string, string>): void {
  for (const [name, text] of Object.entries(sources)) {
    if (!registry.has(name)) registry.add([parseMicroShader(name, text)]);
  }
}
