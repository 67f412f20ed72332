import { expect, it } from 'vitest';
import { asClause, browserReason } from './browserReason';
import { notSaved } from './saveFile';

it.each([
  [new DOMException('', 'QuotaExceededError'), /there is no room left\. Free space/],
  [new DOMException('x', 'NotAllowedError'), /may not write there any more\. Allow it/],
  [new DOMException('x', 'NotFoundError'), /no longer there\. Choose another place/],
  [new DOMException('Blocked by Safe Browsing.', 'AbortError'), /refused the file\. Save again under another name/],
  [new Error('The disk is full.'), /the disk is full\. Save again/],
  [new Error(''), /the browser gives no reason but Error\. Save again/],
  ['broken', /broken\. Save again/],
  [null, /null\. Save again/],
])('a save that fails with %s says in one sentence the file, why, and what to do', (error, text) => {
  const { message } = notSaved('kept.json', error);
  expect(message).toMatch(/^“kept.json” was not saved: /);
  expect(message).toMatch(text);
  expect(message).not.toMatch(/\.\.|\n/);
});

it('a long message of the browser is cut, one with an abbreviation keeps its capitals', () => {
  expect(browserReason(new Error('word '.repeat(1000))).why.length).toBeLessThan(210);
  expect(asClause({ name: 'Error', message: 'GPU process is gone.' })).toBe('GPU process is gone');
});
