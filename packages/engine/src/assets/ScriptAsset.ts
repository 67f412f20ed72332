import { string } from '@farol/editing/fields';
import { DataAsset } from './FieldAsset';

export const scriptFields = {
  source: string('', { help: 'Text: a module that exports a component class by default.' }),
};

/**
 * A script of a library: the text of a module in TypeScript, or in JavaScript where its name ends in `.js`. Its default
 * export is a class that extends `component({ … })` of `@farol/engine/fields`.
 */
export class ScriptAsset extends DataAsset {
  static readonly fields = scriptFields;
  override readonly type = 'script';

  /** JavaScript text of the module. */
  get source(): string {
    return this.get('source') as string;
  }
}
