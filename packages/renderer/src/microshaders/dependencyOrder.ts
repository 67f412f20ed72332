import type { MicroShader } from './MicroShader';
import { nearestName } from './nearestName';

/** Where chunks are looked up. */
export interface MicroShaderSource {
  get(name: string): MicroShader | undefined;
  names(): readonly string[];
}

/**
 * The chunks of the list with all their dependencies, each once, none before what it depends on.
 * @throws Error for an unknown name or a cycle, with the path to it
 */
export function dependencyOrder(names: readonly string[], source: MicroShaderSource): MicroShader[] {
  const done = new Set<string>();
  const order: MicroShader[] = [];
  const visit = (name: string, path: readonly string[]) => {
    if (done.has(name)) return;
    const here = [...path, name];
    if (path.includes(name)) throw new Error(`Microshader cycle: ${here.slice(path.indexOf(name)).join(' -> ')}`);
    const chunk = source.get(name);
    if (chunk === undefined) throw new Error(unknownMessage(name, here, source));
    for (const dependency of chunk.dependencies) visit(dependency, here);
    done.add(name);
    order.push(chunk);
  };
  for (const name of names) visit(name, []);
  return order;
}

function unknownMessage(name: string, path: readonly string[], source: MicroShaderSource): string {
  const nearest = nearestName(name, source.names());
  return (
    `Unknown microshader "${name}"${path.length > 1 ? ` (${path.join(' -> ')})` : ''}` +
    (nearest === undefined ? '; add it to the registry first.' : `; did you mean "${nearest}"?`)
  );
}
