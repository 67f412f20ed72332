import * as engine from '@farol/engine';
import * as fields from '@farol/engine/fields';
import { compileScript, ScriptError, takeGiven } from '@farol/engine/scripts';
import * as three from 'three';
import { DocumentScripts } from '../DocumentScripts';

/** Runs a document's scripts in Node. */
export const scriptsInNode = (): DocumentScripts =>
  new DocumentScripts(() => ({
    modules: { three, '@farol/engine': engine, '@farol/engine/fields': fields },
    compile: compileScript,
    run({ name, code }) {
      try {
        // oxlint-disable-next-line no-eval -- runs code as a page's script element does
        (0, eval)(code);
      } catch (error) {
        throw new ScriptError(name, (error as Error).message);
      }
      return takeGiven(name);
    },
  }));
