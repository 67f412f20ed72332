import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { root } from './root.mjs';

it('is one function in both packages that depend on no other', () => {
  const [renderer, editing] = ['renderer/src/microshaders', 'editing/src'].map((folder) =>
    readFileSync(join(root, 'packages', folder, 'shortText.ts'), 'utf8'),
  );
  expect(editing).toBe(renderer);
});
