import { GIVEN, nobodyWrites, type Resource, type ResourceUser } from './Resources';

/**
 * Checks that each pass reads only resources that an earlier one wrote, that none reads what it writes (except the target), and
 * that the last one writes the target.
 * @throws Error that names the pass and the resource
 */
export function validatePasses(technique: string, passes: readonly ResourceUser[]): void {
  const written = new Set<Resource>(GIVEN);
  for (const pass of passes) {
    for (const resource of pass.reads) {
      if (!written.has(resource)) throw nobodyWrites(technique, pass.name, resource);
      if (resource !== 'target' && pass.writes.includes(resource)) {
        throw new Error(`Technique "${technique}": pass "${pass.name}" reads and writes "${resource}"; use two.`);
      }
    }
    for (const resource of pass.writes) written.add(resource);
  }
  if (!passes.some((pass) => pass.writes.includes('target'))) {
    throw new Error(`Technique "${technique}": no pass writes "target"; end it with forwardTail().`);
  }
}
