import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';
import { expect, it } from 'vitest';

const FOLDER = join(root, 'e2e/pages/authoring');
const page = readFileSync(join(root, 'packages/renderer/docs/authoring.md'), 'utf8');
const sources = readdirSync(FOLDER).map((name) => readFileSync(join(FOLDER, name), 'utf8'));

it('shows whole files that the browser tests draw with, word for word, in 160 lines', () => {
  const blocks = [...page.matchAll(/```(?:ts|glsl)\n(.*?)```/gs)].map(([, code]) => code);
  expect(blocks.toSorted()).toEqual(sources.toSorted());
  expect(page.trimEnd().split('\n').length).toBeLessThanOrEqual(160);
});
