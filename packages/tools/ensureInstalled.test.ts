import { expect, it } from 'vitest';
import { needsInstall } from './ensureInstalled.mjs';

it('installs in a fresh clone and after the lock file changed, not otherwise', () => {
  expect(needsInstall(null, 10)).toBe(true);
  expect(needsInstall(10, 11)).toBe(true);
  expect(needsInstall(11, 10)).toBe(false);
});
