/** Scripts of scenes: compiling, running and error reports. */
export type { CompiledScript, ScriptFunction, ScriptRunner } from './CompiledScript';
export { compileScript } from './compileScript';
export { resolveScript } from './resolveScript';
export { givenScripts, runInPage, takeGiven } from './runInPage';
export { SceneScripts, type SceneScriptsOptions } from './SceneScripts';
export { ScriptError, type ScriptPlace } from './ScriptError';
export { typeNameOf } from './scriptClass';
export { placeOfError, scriptUrl } from './scriptUrl';
