import type { MicroShader } from './MicroShader';

const INCLUDE = /^[ \t]*#include "(\w+)"[ \t]*$/gm;

/** A microshader from the text of its file: header, then after a line `//# main` its piece of main(). */
export function parseMicroShader(name: string, text: string): MicroShader {
  const [head, main = ''] = text.split(/^\/\/# main[ \t]*$/m);
  const dependencies = [...head.matchAll(INCLUDE)].map((match) => match[1]);
  return { name, header: head.replace(INCLUDE, '').trim(), main: main.trim(), dependencies };
}
