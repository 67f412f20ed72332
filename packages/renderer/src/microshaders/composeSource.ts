import { dependencyOrder, type MicroShaderSource } from './dependencyOrder';
import type { MicroShader } from './MicroShader';
import { INCLUDE_LINE } from './parseMicroShader';

const THREE_INCLUDE = /^[ \t]*#include[ \t]+<([^>]+)>/;

/** Headers of these chunks and all their dependencies, each once, framed for `explainCompileError`. */
export function composeHeaders(
  names: readonly string[],
  source: MicroShaderSource,
  stage?: 'vertex' | 'fragment',
): string {
  const chunks = dependencyOrder(names, source);
  const misplaced = stage && chunks.find((chunk) => (chunk.stage ?? 'both') !== 'both' && chunk.stage !== stage);
  if (misplaced) {
    throw new Error(
      `Microshader "${misplaced.name}" is for the ${misplaced.stage} stage, and a ${stage} shader uses it; give it the stage both.`,
    );
  }
  return chunks.map((chunk) => framed(chunk, chunk.header, chunk.headerLine)).join('');
}

/** A whole shader: headers, then `main()` with the main parts of the listed chunks in order. */
export function composeStage(
  names: readonly string[],
  source: MicroShaderSource,
  stage: 'vertex' | 'fragment',
): string {
  const headers = composeHeaders(names, source, stage);
  const mains = names.map((name) => source.get(name)!).map((chunk) => framed(chunk, chunk.main, chunk.mainLine));
  return `${headers}void main() {\n${mains.join('')}}\n`;
}

/**
 * Lines between `// <name>` (or `// <name> 7`, when the first is line 7 of the chunk) and `// </name>`. Lines included by three
 * are framed as `// <three/…>`. Line numbers are kept: an `#include "name"` becomes an empty line.
 */
function framed({ name }: MicroShader, text: string, first = 1): string {
  if (text.trim() === '') return '';
  const frame = (line: number) => `// <${name}>${line === 1 ? '' : ` ${line}`}\n`;
  let result = frame(first);
  text
    .replace(/\n$/, '')
    .split('\n')
    .forEach((line, i) => {
      const include = THREE_INCLUDE.exec(line);
      if (include) result += `// <three/${include[1]}>\n${line}\n${frame(first + i + 1)}`;
      else result += INCLUDE_LINE.test(line) ? '\n' : `${line}\n`;
    });
  return `${result}// </${name}>\n`;
}
