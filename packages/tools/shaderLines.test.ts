import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { longLines, MOST_COLUMNS } from './longLines.mjs';
import { filesEnding } from './sourceFiles.mjs';
import { root } from './root.mjs';

describe('lines of shaders', () => {
  it(`have at most ${MOST_COLUMNS} columns`, () => {
    const files = filesEnding('.glsl');
    expect(files.length).toBeGreaterThan(100);
    expect(files.flatMap((path) => longLines(path, readFileSync(join(root, path), 'utf8')))).toEqual([]);
  });

  it('are counted in characters, and told by file and line', () => {
    const fits = 'é'.repeat(MOST_COLUMNS);
    expect(longLines('x.glsl', `${fits}\r\n${fits}\n`)).toEqual([]);
    expect(longLines('x.glsl', `\n${fits}é`)).toEqual(['x.glsl:2 has 121 columns']);
  });
});
