import { checkFieldValue } from '@farol/editing/fields';
import { Component } from '../core/Component';
import type { ComponentClass } from '../core/ComponentClass';
import { scriptClasses } from '../core/scriptClasses';
import { asScriptError, type ScriptModule } from './ScriptModules';
import { ScriptError } from './ScriptError';

/** Default type name of a script's components: the asset's name without folder and extension. */
export const typeNameOf = (script: string): string =>
  script.slice(script.lastIndexOf('/') + 1).replace(/\.(m?js|ts)$/, '');

/**
 * Class of components that a script exports; null for a script without a default export, which only others import.
 * @param hadClass - whether an earlier text of the script exported a class
 * @throws ScriptError when the default export is no component class, or its constructor throws
 */
export function scriptClass({ name, exports }: ScriptModule, source: string, hadClass: boolean): ComponentClass | null {
  const type = exports.default as ComponentClass | undefined;
  const lineOf = (pattern: RegExp): number => source.split('\n').findIndex((text) => pattern.test(text)) + 1;
  const line = lineOf(/^\s*export default\b/);
  const fail = (problem: string): never => {
    throw new ScriptError(name, problem, line);
  };
  if (type === undefined) {
    const at = lineOf(/\bextends\s+component\s*\(/);
    if (!hadClass && at === 0) return null;
    throw new ScriptError(name, 'it exports no class: write `export default class … extends component({ … })`.', at);
  }
  if (typeof type !== 'function' || !((type.prototype as unknown) instanceof Component)) {
    return fail(
      'its default export is not a component class: write `export default class … extends component({ … })`.',
    );
  }
  for (const [field, declared] of Object.entries(type.fields)) {
    if (typeof declared?.kind !== 'string')
      fail(
        `its field '${field}' is not declared: write number(1), boolean(true) or another field of '@farol/engine/fields'.`,
      );
    const problem = checkFieldValue(declared, declared.default);
    if (problem !== null) fail(`the default of its field '${field}' ${problem}.`);
  }
  if (!Object.hasOwn(type, 'typeName') || !type.typeName) {
    Object.defineProperty(type, 'typeName', { value: typeNameOf(name), configurable: true });
  }
  scriptClasses.add(type);
  try {
    // a class whose constructor throws must not replace one that works
    new type();
  } catch (error) {
    throw asScriptError(error, name);
  }
  return type;
}
