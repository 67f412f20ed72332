import type { MicroShaderRegistry } from './MicroShaderRegistry';
import { parseMicroShader } from './parseMicroShader';

interface Added {
  readonly owner: string;
  readonly text: string;
}

/** Original texts of microshaders added to each registry, by name, before live edits. */
const added = new WeakMap<MicroShaderRegistry, Map<string, Added>>();

/**
 * Adds chunks, which several parts of a page may share, to a renderer's registry, each once. An edit made before remains in use.
 * @param owner - name of the part that adds them, for errors
 * @param sources - texts by name
 * @throws Error when a name has another text already; then no chunk is added
 */
export function addMicroShaders(
  registry: MicroShaderRegistry,
  owner: string,
  sources: Readonly<Record<string, string>>,
): void {
  const known = added.get(registry) ?? new Map<string, Added>();
  added.set(registry, known);
  const fresh = Object.entries(sources).filter(([name, text]) => {
    const before = known.get(name);
    if (before === undefined && (!registry.has(name) || registry.isEarly(name))) return true;
    if (before?.text === text) return false;
    throw new Error(
      `Microshader "${name}" of ${owner} differs from that of ${before?.owner ?? 'Farol'}; give it another name.`,
    );
  });
  const chunks = fresh.map(([name, text]) => parseMicroShader(name, text));
  registry.add(chunks.filter(({ name }) => !registry.has(name)));
  for (const chunk of chunks) if (registry.isEarly(chunk.name)) registry.swap(chunk.name, chunk);
  for (const [name, text] of fresh) known.set(name, { owner, text });
}
