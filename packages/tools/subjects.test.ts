import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';
import { components, specsOf, subjects } from './subjects.mjs';

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

it('finds a component by the beginning of its name, of which each has a file', () => {
  const files = filesEnding('.ts');
  const strays = components.filter(([start]) => !files.some((path) => path.startsWith(start)));
  expect(strays).toEqual([]);
  expect(specsOf('packages/engine/src/components/RigidBody.ts')).toEqual(['e2e/editor/physics.spec.ts']);
  expect(specsOf('packages/engine/src/components/ObjectRenderer.ts')).toEqual(['e2e/editor/components.spec.ts']);
});

it('names specs of which the slice has tests, since it runs no others', () => {
  const names = [...subjects.flatMap(([, specs]) => specs), ...components.map(([, spec]) => spec)];
  const empty = names.filter((name) => {
    const text = readFileSync(join(root, `e2e/${name}.spec.ts`), 'utf8');
    const titles = [...text.matchAll(/^ *(?:test|own|shared)\(\s*(['"`])(.*?)\1,/gm)].map((match) => match[2]);
    return titles.every((title) => title.endsWith(' @verify'));
  });
  expect([...new Set(empty)]).toEqual([]);
});
