import { runInNewContext } from 'node:vm';
import { expect, test } from 'vitest';
import { messageOf } from './messageOf';

test.each([
  ['an error', new TypeError('No.'), 'No.'],
  ['an error of another realm', runInNewContext("new Error('No.')"), 'No.'],
  ['an error without words', new RangeError(), 'RangeError'],
  ['a text', 'No.', 'No.'],
  ['nothing', undefined, 'undefined'],
  ['null', null, 'null'],
])('%s', (_, error, message) => expect(messageOf(error)).toBe(message));
