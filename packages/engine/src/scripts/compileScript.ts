import { needsPackage } from '../base/needsPackage';
import type { CompiledScript } from './CompiledScript';
import type { ScriptError } from './ScriptError';

/**
 * Makes JavaScript of the text of a script: types are taken out, imports become calls of `require`, loops check a time limit.
 * Lines stay where they are.
 * @param name - of the script asset: TypeScript, or JavaScript where it ends in `.js`
 * @returns the error, with line and column, where the text cannot be read; errors that only the browser's own compiler finds
 * come when it is run
 * @throws Error (as a rejection) when the package sucrase cannot be loaded
 */
export async function compileScript(name: string, source: string): Promise<CompiledScript | ScriptError> {
  const { transformScript } = await needsPackage('sucrase', 'Scripts need', import('./transformScript'));
  return transformScript(name, source);
}
