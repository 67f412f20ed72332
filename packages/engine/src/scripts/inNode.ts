import { runInThisContext } from 'node:vm';
import * as three from 'three';
import * as engine from '../index';
import * as fields from '../fields/index';
import { takeGiven } from './runInPage';
import { ScriptError } from './ScriptError';
import type { SceneScriptsOptions } from './SceneScripts';

/** What scripts get in tests, run in Node. */
export const inNode: SceneScriptsOptions = {
  modules: { three, '@farol/engine': engine, '@farol/engine/fields': fields },
  run({ name, code }) {
    try {
      runInThisContext(code);
    } catch (error) {
      throw new ScriptError(name, (error as Error).message);
    }
    return takeGiven(name);
  },
};
