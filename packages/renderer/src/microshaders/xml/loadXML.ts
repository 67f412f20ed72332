import type { MicroShader } from '../MicroShader';
import { shortText } from '../shortText';
import { parseMicroShaderXML } from './parseMicroShaderXML';

/** Parts of a MicroShaderRegistry that loading uses. */
interface Registry {
  has(name: string): boolean;
  add(chunks: readonly MicroShader[]): void;
}

/** Adds the microshaders of an XML text to a registry. @param file - name of the file, for errors @returns their names */
export function loadXML(registry: Registry, text: string, file: string): string[] {
  const chunks = parseMicroShaderXML(text, file);
  const known = chunks.find(({ name }) => registry.has(name));
  if (known)
    throw new Error(`${shortText(file)}: microshader "${shortText(known.name)}" exists already; give it another name.`);
  registry.add(chunks);
  return chunks.map(({ name }) => name);
}

/** Adds the microshaders of the XML file at a URL to a registry. @returns their names */
export async function fetchXML(registry: Registry, url: string): Promise<string[]> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: the server answers ${response.status}; is the address of the file right?`);
  return loadXML(registry, await response.text(), url);
}
