import * as engine from '@farol/engine';
import * as fields from '@farol/engine/fields';
import {
  type CompiledScript,
  givenScripts,
  runInPage,
  SceneScripts,
  ScriptError,
  takeGiven,
} from '@farol/engine/scripts';
import * as three from 'three';
import type { RunScripts } from './play';

type Compile = (name: string, source: string) => CompiledScript | ScriptError;

/** URL of the script compiler, for linked scenes; it sets `globalThis.farolCompile`. */
const COMPILER = './farol-script-compiler.js';

function loadCompiler(): Promise<Compile> {
  const element = document.createElement('script');
  element.src = COMPILER;
  return new Promise((resolve, reject) => {
    element.addEventListener('load', () => resolve((globalThis as unknown as { farolCompile: Compile }).farolCompile));
    element.addEventListener('error', () =>
      reject(new Error(`The script compiler ${element.src} could not be read: reload the page.`)),
    );
    document.head.append(element);
  });
}

/** Runs the scripts of a scene: compiled in an exported page, else compiled here. */
export const runScripts: RunScripts = async (scene, registry) => {
  // compiled scripts of an exported page have run before this one
  const isCompiled = document.getElementById('farol-scene') !== null;
  const compile = isCompiled ? null : await loadCompiler();
  const scripts = new SceneScripts(scene, registry, {
    modules: { three, '@farol/engine': engine, '@farol/engine/fields': fields },
    compile: (name, source) =>
      Promise.resolve(
        compile
          ? compile(name, source)
          : givenScripts()[name]
            ? { name, source, code: '' }
            : new ScriptError(name, 'it is not in this page: export the scene again.'),
      ),
    run: (script) => (compile ? runInPage(script) : takeGiven(script.name)),
  });
  await scripts.settled();
  for (const { message } of scripts.errors.values()) console.error(message);
};
