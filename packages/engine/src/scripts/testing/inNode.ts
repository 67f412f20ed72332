import * as three from 'three';
import * as engine from '../../index';
import * as fields from '../../componentFields';
import { compileScript } from '../compileScript';
import { takeGiven } from '../runInPage';
import { ScriptError } from '../ScriptError';
import type { SceneScriptsOptions } from '../SceneScripts';

/** Modules and runner of scripts for tests in Node. */
export const inNode: SceneScriptsOptions = {
  modules: { three, '@farol/engine': engine, '@farol/engine/fields': fields },
  compile: compileScript,
  run({ name, code }) {
    try {
      // oxlint-disable-next-line no-eval -- in the page it is a script element that runs it
      (0, eval)(code);
    } catch (error) {
      throw new ScriptError(name, (error as Error).message);
    }
    return takeGiven(name);
  },
};
