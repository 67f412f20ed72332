import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { checkBuilt } from './packPackages.mjs';

let checkout: string;

beforeEach(() => {
  checkout = mkdtempSync(join(tmpdir(), 'farol-pack-'));
  mkdirSync(join(checkout, 'packages/lamp/dist'), { recursive: true });
  const exports = { '.': { types: './dist/index.d.ts', default: './dist/index.js' }, './*.js': null };
  writeFileSync(
    join(checkout, 'packages/lamp/package.json'),
    JSON.stringify({ name: '@x/lamp', version: '1.0.0', exports }),
  );
});

afterEach(() => rmSync(checkout, { recursive: true }));

it('packs no package that is not built', () => {
  for (const name of ['index.d.ts', 'index.js']) {
    expect(() => checkBuilt(checkout)).toThrow(`packages/lamp has no ./dist/${name}: npm run pack`);
    writeFileSync(join(checkout, 'packages/lamp/dist', name), '');
  }
  expect(() => checkBuilt(checkout)).not.toThrow();
});
