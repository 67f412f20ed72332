// an optional peer dependency: when it is absent, bundlers fail on named imports, but not on a namespace
import * as sucrase from 'sucrase';
import type { CompiledScript } from './CompiledScript';
import { guardLoops } from './guardLoops';
import { ScriptError } from './ScriptError';
import { isTypeScript, scriptUrl } from './scriptUrl';

/** Compiles a script's text to JavaScript: the late code of `compileScript`. */
export function transformScript(name: string, source: string): CompiledScript | ScriptError {
  try {
    const { code } = sucrase.transform(source, {
      transforms: isTypeScript(name) ? ['typescript', 'imports'] : ['imports'],
      disableESTransforms: true,
    });
    const head = `(globalThis.farolScripts??={})[${JSON.stringify(name)}]=function(require,exports,module,$check){"use strict";let $passes=0;`;
    return { name, source, code: `${head}${guardLoops(code)}\n};\n//# sourceURL=${scriptUrl(name)}\n` };
  } catch (error) {
    const { loc, message } = error as Error & { loc?: { line: number; column: number } };
    const problem = message.replace(/ \(\d+:\d+\)$/, '');
    return new ScriptError(name, problem, loc?.line ?? 0, loc?.column ?? 0, { cause: error });
  }
}
