import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it, test } from 'vitest';
import { promiseFaults, promisesOf } from './promises.mjs';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';

const pages = ['packages/renderer/docs/promises.md', 'apps/editor/docs/promises.md'];
/** Folder of the site, whose pages show those. */
const site = 'apps/site/';
const read = (path: string): string | null =>
  existsSync(join(root, path)) ? readFileSync(join(root, path), 'utf8') : null;

test.each(pages)('each promise of %s names tests that are there and run in verify', (path) => {
  const promises = promisesOf(read(path)!);
  expect(promises.length).toBeGreaterThan(9);
  expect(promises.flatMap((promise) => promiseFaults(promise, read))).toEqual([]);
});

it('no page of promises is left out, nor an item of one that is not in bold', () => {
  const found = filesEnding('/promises.md').filter((path) => !path.startsWith(site));
  expect(found.toSorted()).toEqual(pages.toSorted());
  for (const path of pages) expect(read(path)!.match(/^[-*] (?!\*\*)/m), path).toBeNull();
});

it('A save never overwrites what it has not seen is among the promises', () => {
  expect(promisesOf(read('apps/editor/docs/promises.md')!).map(({ name }) => name)).toContain(
    'A save never overwrites what it has not seen.',
  );
});

test.each([
  ['- **Kept**: always. `e2e/a.spec.ts` "it is kept", "for long"; more by hand', []],
  ['- **Kept** always.', ['Kept: no test is named']],
  ['- **Kept** `e2e/b.spec.ts` "it is kept"', ['Kept: there is no e2e/b.spec.ts']],
  ['- **Kept** `e2e/a.spec.ts`', ['Kept: no title of a test of e2e/a.spec.ts is named']],
  ['- **Kept** `e2e/a.spec.ts` "it is lost"', ['Kept: e2e/a.spec.ts has no test "it is lost"']],
  ['- **Kept** `e2e/a.spec.ts` "by hours"', ['Kept: "by hours" does not run in verify']],
])('%s', (page, faults) => {
  const source = "test('it is kept', f);\ntest('kept for long @verify', f);\ntest('by hours @long', f);\n";
  const [promise] = promisesOf(page);
  expect(promiseFaults(promise, (path) => (path === 'e2e/a.spec.ts' ? source : null))).toEqual(faults);
});
