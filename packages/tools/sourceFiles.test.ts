import { readdirSync } from 'node:fs';
import { relative } from 'node:path';
import { expect, test, vi } from 'vitest';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';

vi.mock('node:fs', async (load) => {
  const fs = await load<typeof import('node:fs')>();
  return { ...fs, readdirSync: vi.fn<typeof fs.readdirSync>(fs.readdirSync) };
});

test('sources are found without a look into folders that a build or an install empties meanwhile', () => {
  expect(filesEnding('.test.ts')).toContain('packages/tools/sourceFiles.test.ts');
  const { calls } = vi.mocked(readdirSync).mock;
  const entered = calls.map(([folder]) => relative(root, String(folder)).replaceAll('\\', '/'));
  expect(entered).toContain('packages/tools');
  expect(entered.filter((folder) => /(^|\/)(node_modules|dist|\.cache)(\/|$)/.test(folder))).toEqual([]);
});
