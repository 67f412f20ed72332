import { gzipSync } from 'node:zlib';
import { expect, it } from 'vitest';
import { extractTar } from './extractTar.mjs';

/** A header of ustar, and the contents in blocks of 512 bytes. */
function entry(path: string, text: string, prefix = '', type = '0'): Buffer {
  const header = Buffer.alloc(512);
  header.write(path, 0);
  header.write(`${text.length.toString(8).padStart(11, '0')}\0`, 124);
  header.write(type, 156);
  header.write('ustar\0', 257);
  header.write(prefix, 345);
  const body = Buffer.alloc(Math.ceil(text.length / 512) * 512);
  body.write(text);
  return Buffer.concat([header, body]);
}

it('gives the files that are asked for, with their whole paths', () => {
  const long = 'x'.repeat(700);
  const archive = gzipSync(
    Buffer.concat([
      entry('package/a.txt', 'first'),
      entry('folder/', '', 'package', '5'),
      entry('folder/b.txt', long, 'package'),
      entry('package/c.bin', 'left out'),
      Buffer.alloc(1024),
    ]),
  );
  const files = extractTar(archive, (path) => path.endsWith('.txt'));
  expect(files.map(({ path, bytes }) => [path, bytes.toString()])).toEqual([
    ['package/a.txt', 'first'],
    ['package/folder/b.txt', long],
  ]);
});
