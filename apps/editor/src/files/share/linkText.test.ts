import { FileError, type UnpackQuestion } from '@farol/engine/files';
import { deflateRawSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { decodeLink, encodeLink } from './linkText';

const bomb = `#scene=${deflateRawSync(Buffer.alloc(80 * 2 ** 20, ' ')).toString('base64url')}`;

test('a link gives its text back', async () => {
  expect(await decodeLink(await encodeLink('{"name":"ü"}'))).toBe('{"name":"ü"}');
});

test('a link of 100 kB that becomes 84 MB is asked about while it is unpacked, and refused where nobody can be', async () => {
  await expect(decodeLink(bomb)).rejects.toBeInstanceOf(FileError);
  await expect(decodeLink(bomb)).rejects.toThrow(/would grow from \d+ kB to \d\d MB .* 67 MB is the limit/);
  const asked: UnpackQuestion[] = [];
  const answer = decodeLink(bomb, (sizes) => asked.push(sizes) < 0);
  await expect(answer).rejects.toMatchObject({ name: 'AbortError' });
  expect(asked).toHaveLength(1);
});

test.each(['#scene=%%%', '#scene=abc', '#scene=AAAA'])('a damaged link is named: %s', async (hash) => {
  await expect(decodeLink(hash)).rejects.toThrow(/damaged or cut short/);
});
