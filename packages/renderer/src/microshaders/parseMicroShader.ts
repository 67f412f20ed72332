import type { MicroShader, MicroShaderStage } from './MicroShader';
import { shortText } from './shortText';

const MAIN_LINE = /^[ \t]*\/\/#[ \t]*main[ \t]*$/m;
export const STAGE_LINE = /^[ \t]*\/\/#[ \t]*stage[ \t]+(\w*)[ \t]*$/m;
/** Matches `#include "name"`, not three's `#include <name>`. */
export const INCLUDE_LINE = /^[ \t]*#include[ \t]+"([^"\n]*)"[ \t]*(?:\/\/.*)?$/;

/**
 * Parses a microshader from the text of a `.glsl` file: its header, then after a line `//# main` its part of `main()`. By
 * convention the file's first line gives its purpose, the second the paper or specification. A line `//# stage vertex` or
 * `//# stage fragment` limits it to that stage; `#include "name"` lines of the header are its dependencies.
 * @throws Error for an include in the main part, or an invalid stage or name
 */
export function parseMicroShader(name: string, text: string): MicroShader {
  const lines = text.replace(/\r\n?/g, '\n');
  const split = MAIN_LINE.exec(lines);
  const header = split ? lines.slice(0, split.index) : lines;
  const main = split ? lines.slice(split.index + split[0].length + 1) : '';
  const headerLines = header.split('\n').length;
  const stage = STAGE_LINE.exec(header)?.[1];
  return completeMicroShader({
    name,
    header,
    main,
    dependencies: [],
    ...(stage !== undefined && { stage: stage as MicroShaderStage }),
    mainLine: headerLines + 1,
  });
}

/**
 * Checks a chunk and adds the names that it includes to its dependencies, each once.
 * @throws Error for an include in the main part, or an invalid stage or name
 */
export function completeMicroShader(chunk: MicroShader): MicroShader {
  const { name, header, main, stage = 'both' } = chunk;
  if (!/^[\w./-]+$/.test(name)) {
    throw new Error(`Microshader name "${shortText(name)}": use letters, digits, "_", "-", "." and "/" only.`);
  }
  if (!['vertex', 'fragment', 'both'].includes(stage)) {
    throw new Error(
      `Microshader "${shortText(name)}" has the stage "${shortText(stage)}"; stages are vertex, fragment and both.`,
    );
  }
  if (includesOf(main).length > 0) {
    throw new Error(
      `Microshader "${shortText(name)}" includes a chunk in its main part; put the #include line into its header.`,
    );
  }
  return { ...chunk, dependencies: [...new Set([...chunk.dependencies, ...includesOf(header)])] };
}

/** Names that a text includes. */
export function includesOf(text: string): string[] {
  return text.split('\n').flatMap((line) => INCLUDE_LINE.exec(line)?.[1] ?? []);
}
