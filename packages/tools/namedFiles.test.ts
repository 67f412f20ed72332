import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { missingNamedFiles } from './namedFiles.mjs';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';

describe('files that comments name', () => {
  it('exist', () => {
    const files = filesEnding('');
    const sources = filesEnding('.ts', '.tsx', '.mjs', '.glsl');
    expect(sources.length).toBeGreaterThan(700);
    const missing = (path: string) => missingNamedFiles(path, readFileSync(join(root, path), 'utf8'), files);
    expect(sources.flatMap(missing)).toEqual([]);
  });

  const files = ['packages/a/x.glsl', 'packages/a/X.test.ts', 'e2e/y.spec.ts'];

  it.each([
    ['p/a.ts', "// see gone.glsl\nconst text = 'other.glsl'; // and x.glsl", ['p/a.ts names gone.glsl']],
    ['p/a.ts', '/** In `b/x.glsl` and a/x.glsl; packages/a/X.test.ts. */', ['p/a.ts names b/x.glsl']],
    ['p/a.mjs', '// X.ts, y.spec.ts', ['p/a.mjs names X.ts']],
    ['p/a.tsx', 'const a = <b>c</b>; /* z.tsx */', ['p/a.tsx names z.tsx']],
    [
      'p/a.glsl',
      '// layout in Gone.ts\nfloat a; /* gone.glsl */',
      ['p/a.glsl names Gone.ts', 'p/a.glsl names gone.glsl'],
    ],
    ['e2e/a.mjs', "/** @type {import('./y.spec.ts').Y} ../e2e/z.mjs */", ['e2e/a.mjs names ../e2e/z.mjs']],
    ['p/a.ts', '// any *.glsl, `<name>.ts`, {a,b}.ts or https://a.org/x.tsx/y', []],
  ])('are looked for in %s: %s', (path, source, missing) => {
    expect(missingNamedFiles(path, source, files)).toEqual(missing);
  });
});
