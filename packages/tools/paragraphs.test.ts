import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';

/** Letters by which two paragraphs are taken for versions of one. */
const ALIKE = 140;

it('no paragraph stands twice on a page, nor an older version beside a newer one', () => {
  const pages = [...filesEnding('.md'), 'README.md', 'CONTRIBUTING.md'];
  expect(pages.length).toBeGreaterThan(20);
  const twice = pages.flatMap((path) => {
    const begins = readFileSync(join(root, path), 'utf8')
      .split('\n')
      // not lines of tables, which begin alike
      .filter((line) => line.length > ALIKE && !line.startsWith('|'))
      .map((line) => line.slice(0, ALIKE));
    return begins.filter((begin, i) => begins.indexOf(begin) < i).map((begin) => `${path}: ${begin}`);
  });
  expect(twice).toEqual([]);
});
