import type { MicroShader } from './MicroShader';
import { nearestName } from './nearestName';
import { shortText } from './shortText';

/** Maximum depth of dependencies, which are visited recursively. */
const DEEPEST = 200;

/** Source of chunks by name. */
export interface MicroShaderSource {
  get(name: string): MicroShader | undefined;
  names(): readonly string[];
}

/**
 * The chunks of the list and all their dependencies, each once, after its dependencies.
 * @throws Error for an unknown name or a cycle, with the path to it
 */
export function dependencyOrder(names: readonly string[], source: MicroShaderSource): MicroShader[] {
  const done = new Set<string>();
  const order: MicroShader[] = [];
  const visit = (name: string, path: readonly string[]) => {
    if (done.has(name)) return;
    const here = [...path, name];
    if (path.includes(name))
      throw new Error(`Microshader cycle: ${wayOf(here.slice(path.indexOf(name)))}; take one #include out.`);
    if (path.length > DEEPEST)
      throw new Error(`Microshaders are more than ${DEEPEST} includes deep: ${wayOf(here)}; include fewer.`);
    const chunk = source.get(name);
    if (chunk === undefined) throw new Error(unknownMessage(name, here, source));
    for (const dependency of chunk.dependencies) visit(dependency, here);
    done.add(name);
    order.push(chunk);
  };
  for (const name of names) visit(name, []);
  return order;
}

/** Text of a path of names, without the middle of a long one. */
function wayOf(names: readonly string[]): string {
  const way = names.map((name) => shortText(name));
  return (way.length > 8 ? [...way.slice(0, 4), '…', ...way.slice(-3)] : way).join(' -> ');
}

function unknownMessage(name: string, path: readonly string[], source: MicroShaderSource): string {
  const nearest = name.length > 100 ? undefined : nearestName(name, source.names());
  return (
    `Unknown microshader "${shortText(name)}"${path.length > 1 ? ` (${wayOf(path)})` : ''}` +
    (nearest === undefined ? '; add it to the registry first.' : `; did you mean "${nearest}"?`)
  );
}
