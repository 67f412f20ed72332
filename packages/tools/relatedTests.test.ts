import { expect, it } from 'vitest';
import { importGraph } from './importCircles.mjs';
import { relatedTests } from './relatedTests.mjs';

const files = new Map([
  ['packages/a/cull.ts', ''],
  ['packages/a/sphere.test.ts', ''],
  ['packages/b/Frame.ts', "import '../a/cull';"],
  ['packages/b/Frame.test.ts', "import './Frame';"],
  ['packages/b/other.test.ts', "import './Frame';"],
  ['packages/c/far.test.ts', "import '../a/cull';"],
  ['packages/d/lights.ts', "import text from './lights.glsl?raw';"],
  ['packages/d2/lights.test.ts', "import '../d/lights';"],
  ['packages/tools/importDirection.test.ts', ''],
]);

it('finds tests beside a file, tests that import it, and those of what imports it', () => {
  expect(relatedTests(['packages/a/cull.ts'], files, importGraph(files))).toEqual([
    'packages/a/sphere.test.ts',
    'packages/b/Frame.test.ts',
    'packages/c/far.test.ts',
    'packages/tools/importDirection.test.ts',
  ]);
});

it('finds those of what reads a shader as text', () => {
  const withTest = new Map([...files, ['packages/d/lights.test.ts', '']]);
  expect(relatedTests(['packages/e/lights.glsl'], withTest, importGraph(withTest))).toContain(
    'packages/d/lights.test.ts',
  );
});
