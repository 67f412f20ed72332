import { MicroShaderCompileError } from '../microshaders/MicroShaderCompileError';

/** An error at a line of a surface's text (from 1), in the form of a compiler's error. */
export function surfaceError(name: string, text: string, line: number, message: string): MicroShaderCompileError {
  return new MicroShaderCompileError(name, 'fragment', `ERROR: 0:${line + 1}: ${message}`, `// <${name}>\n${text}\n`);
}
