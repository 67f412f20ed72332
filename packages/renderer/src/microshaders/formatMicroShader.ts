import type { MicroShader } from './MicroShader';
import { includesOf, STAGE_LINE } from './parseMicroShader';

/** The text of a `.glsl` file that `parseMicroShader` reads as this chunk. */
export function formatMicroShader(chunk: MicroShader): string {
  let { header } = chunk;
  const included = includesOf(header);
  for (const name of chunk.dependencies.toReversed()) {
    if (!included.includes(name)) header = `#include "${name}"\n${header}`;
  }
  if (chunk.stage && !STAGE_LINE.test(header)) header = `//# stage ${chunk.stage}\n${header}`;
  if (chunk.main === '') return header;
  return `${header}${header.endsWith('\n') || header === '' ? '' : '\n'}//# main\n${chunk.main}`;
}
