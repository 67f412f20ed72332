import { expect, it } from 'vitest';
import { shortText } from './shortText';

it('cuts text of a user off for a message, and writes what cannot be seen', () => {
  expect(shortText('a lamp')).toBe('a lamp');
  expect(shortText('x'.repeat(41))).toBe(`${'x'.repeat(39)}…`);
  expect(shortText('abcdef', 3)).toBe('ab…');
  expect(shortText('a\nb\u202ec\ud800')).toBe('a\\u{a}b\\u{202e}c\\u{d800}');
  expect(shortText('🦉')).toBe('🦉');
});
