import { describe, expect, it } from 'vitest';
import { circlesAcrossFolders, importCircles, importGraph } from './importCircles.mjs';
import { sourceFiles } from './sourceFiles.mjs';

const circlesOf = (files: Record<string, string>, kind: 'static' | 'fetched' | 'types' = 'static'): string[][] =>
  importCircles(importGraph(new Map(Object.entries(files))), kind);

describe('import circles', () => {
  it('are none, but for those of types within one folder', () => {
    const graph = importGraph(sourceFiles());
    expect(graph.size).toBeGreaterThan(500);
    expect(importCircles(graph, 'fetched')).toEqual([]);
    expect(circlesAcrossFolders(importCircles(graph, 'types'))).toEqual([]);
  });

  it('are found through values, types, re-exports, folders and types of import()', () => {
    const files = {
      'p/a.ts': "import { b } from './b';",
      'p/b.ts': "import type { C } from './c';",
      'p/c.tsx': "export { d } from './d';\nconst jsx = <b>c</b>;",
      'p/d/index.ts': "type T = Promise<import('../e').E>;",
      'p/e.ts': "export * from './a';",
      'p/f.ts': "import { a } from './a';",
    };
    expect(circlesOf(files, 'types')).toEqual([['p/a.ts', 'p/b.ts', 'p/c.tsx', 'p/d/index.ts', 'p/e.ts']]);
    expect(circlesOf(files)).toEqual([]);
    expect(circlesOf(files, 'fetched')).toEqual([]);
  });

  it('are of values where only the names of an import are types: its module is loaded', () => {
    const files = { 'p/a.ts': "import { type B } from './b';", 'p/b.ts': "import { a } from './a';" };
    expect(circlesOf(files)).toEqual([['p/a.ts', 'p/b.ts']]);
  });

  it('of types may be within one folder, however deep', () => {
    expect(circlesAcrossFolders([['p/src/core/a.ts', 'p/src/core/x/b.ts']])).toEqual([]);
    expect(circlesAcrossFolders([['e2e/pages/a.ts', 'e2e/pages/b.ts']])).toEqual([]);
    expect(circlesAcrossFolders([['p/src/core/a.ts', 'p/src/files/b.ts']])).toEqual([
      'a circle over p/src/core, p/src/files: p/src/core/a.ts, p/src/files/b.ts',
    ]);
    expect(circlesAcrossFolders([['p/src/a.ts', 'p/src/core/b.ts']])).toHaveLength(1);
  });

  it('are told apart, the largest first, and may be one file', () => {
    const files = {
      'p/a.ts': "import './b';\nimport './x';",
      'p/b.ts': "import './c';",
      'p/c.ts': "import './a';",
      'p/x.ts': "import './y.ts';",
      'p/y.ts': "import './x';",
      'p/self.ts': "import './self';",
    };
    expect(circlesOf(files)).toEqual([['p/a.ts', 'p/b.ts', 'p/c.ts'], ['p/x.ts', 'p/y.ts'], ['p/self.ts']]);
  });

  it('count what is fetched at run time when asked to, and no comment or text', () => {
    const files = {
      'p/a.ts': "// import './b';\nconst text = \"import './b'\";\nconst b = () => import('./b');",
      'p/b.ts': "import './a';\nimport 'three';\nimport './missing';",
    };
    expect(circlesOf(files)).toEqual([]);
    expect(circlesOf(files, 'fetched')).toEqual([['p/a.ts', 'p/b.ts']]);
  });
});
