import { needsPackage } from '../base/needsPackage';
import type { CompiledScript } from './CompiledScript';
import type { ScriptError } from './ScriptError';

/**
 * Compiles a script to JavaScript: removes types, turns imports into calls of `require`, adds a time limit to loops.
 * Line numbers are kept.
 * @param name - name of the script asset; `.js` means JavaScript, all else TypeScript
 * @returns an error with line and column when the text cannot be parsed; errors that only the browser's compiler finds
 *   are thrown when the script runs
 * @throws Error (as a rejection) when the package sucrase cannot be loaded
 */
export async function compileScript(name: string, source: string): Promise<CompiledScript | ScriptError> {
  const { transformScript } = await needsPackage('sucrase', 'Scripts need', import('./transformScript'));
  return transformScript(name, source);
}
