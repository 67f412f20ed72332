import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';
import { specsOf, subjects } from './subjects.mjs';

it('finds the specs of every source file, each of which exists', () => {
  const files = filesEnding('.ts', '.tsx', '.glsl', '.mjs', '.css').filter((path) => /^\w+\/.+\//.test(path));
  const lost = files.filter((path) => !subjects.some(([folder]) => path.startsWith(`${folder}/`)));
  expect(lost, 'source files without a row').toEqual([]);
  const missing = files.flatMap((path) => [...specsOf(path)]).filter((path) => !existsSync(join(root, path)));
  expect([...new Set(missing)], 'specs that are not there').toEqual([]);
});

it('goes by the first row that holds the file: rows stand behind those of their subfolders, and each can be reached', () => {
  for (const [index, [folder]] of subjects.entries()) {
    const above = subjects.slice(0, index).find(([earlier]) => `${folder}/`.startsWith(`${earlier}/`));
    expect(above?.[0], `row that hides ${folder}`).toBeUndefined();
    expect(existsSync(join(root, folder)), folder).toBe(true);
  }
  expect(specsOf('packages/renderer/src/shadows/x.glsl')[0]).toBe('e2e/render/shadows.spec.ts');
  expect(specsOf('e2e/lab/charts.spec.ts')).toEqual(['e2e/lab/charts.spec.ts']);
});
