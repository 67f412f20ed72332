import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import {
  houseLimits,
  macrosAcrossFiles,
  MOST_LINES,
  parametersWithoutDash,
  riddles,
  tinyFiles,
} from './houseCounts.mjs';
import { importGraph } from './importCircles.mjs';
import { isTestCode } from './importDirection.mjs';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';

const read = (path: string) => readFileSync(join(root, path), 'utf8');
const all = new Map(filesEnding('.ts', '.tsx', '.mjs', '.glsl', '.css').map((path) => [path, read(path)]));
const product = new Map(
  [...all].filter(([path]) => !isTestCode(path) && !path.startsWith('e2e/') && !path.endsWith('.d.ts')),
);
const ending = (files: ReadonlyMap<string, string>, ends: RegExp) =>
  new Map([...files].filter(([path]) => ends.test(path)));
const countLines = (source: string) => source.split('\n').length - 1;

describe('counts of the repository, which may only fall', () => {
  it('docblocks that begin with What, Where, Of, Has or The same', () => {
    const found = [...all].flatMap(([path, source]) => riddles(path, source));
    expect(found.slice(houseLimits.riddles)).toEqual([]);
  });

  it('parameters described without a dash', () => {
    const found = [...all].flatMap(([path, source]) => parametersWithoutDash(path, source));
    expect(found.slice(houseLimits.parametersWithoutDash)).toEqual([]);
  });

  it('files of under 15 lines that one file beside them imports', () => {
    const typeScript = ending(product, /\.tsx?$/);
    const found = tinyFiles(typeScript, importGraph(typeScript));
    expect(found.slice(houseLimits.tinyFiles)).toEqual([]);
  });

  it('macros of shaders that cross files', () => {
    const renderer = ending(product, /^packages\/renderer\//);
    expect(macrosAcrossFiles(renderer).slice(houseLimits.macrosAcrossFiles)).toEqual([]);
  });

  it('lines of product code', () => {
    const lines = [...product.values()].reduce((sum, source) => sum + countLines(source), 0);
    expect(lines).toBeLessThanOrEqual(houseLimits.lines);
  });

  it(`files of more than ${MOST_LINES} lines`, () => {
    const long = [...product].filter(([, source]) => countLines(source) > MOST_LINES).map(([path]) => path);
    expect(long).toEqual([]);
  });
});

describe('what is counted', () => {
  it('reads the first word of a docblock, on its first or second line', () => {
    // not written out: this file is read as well
    const source = '/** - it is. */\n/**\n * Of the mesh.\n */\n/** Whether it is on. */\n// What\n'.replace(
      '-',
      'What',
    );
    expect(riddles('x.ts', source)).toEqual(['x.ts:1 What it is.', 'x.ts:2 Of the mesh.']);
  });

  it('wants a dash before the text of a parameter, with or without a type', () => {
    const described = '/** @param a - text */ /** @param {string} b */ /** @param {{ a: number }} c - text */';
    expect(parametersWithoutDash('x.ts', described)).toEqual([]);
    // not written out: this file is read as well
    const [untyped, typed] = ['a', '{string} b'].map((name) => `/** @param ${name} text */`);
    expect(parametersWithoutDash('x.ts', `${untyped}\n${typed}`)).toEqual(['x.ts:1', 'x.ts:2']);
  });

  it('takes a short file for a part of the one beside it that alone imports it', () => {
    const files = new Map([
      ['a/one.ts', "import './two';\nimport './three';"],
      ['a/two.ts', 'export const two = 2;'],
      ['a/three.ts', 'export const three = 3;'],
      ['b/one.ts', "import '../a/three';"],
    ]);
    expect(tinyFiles(files, importGraph(files))).toEqual(['a/two.ts']);
  });

  it('counts a macro that is defined in one file and read in another, not one of a single file', () => {
    const files = new Map([
      ['a.glsl', '#define FAROL_A\n#ifdef FAROL_B\n#endif'],
      ['b.glsl', '#if defined(FAROL_A)\n#endif\n#define FAROL_C\n#ifdef FAROL_C\n#endif'],
      ['c.ts', "defines: { FAROL_B: '' }"],
    ]);
    expect(macrosAcrossFiles(files)).toEqual(['FAROL_A', 'FAROL_B']);
  });
});
