import { zipSync } from 'three/addons/libs/fflate.module.js';
import { expect, it } from 'vitest';
import { expandZips } from './expandZips';

const bytes = (text: string) => new TextEncoder().encode(text);
const zip = (entries: Record<string, Uint8Array>) =>
  new Uint8Array(zipSync(entries as never)) as Uint8Array<ArrayBuffer>;
const filesOf = (entries: Record<string, string | Uint8Array<ArrayBuffer>>) =>
  new Map(Object.entries(entries).map(([path, content]) => [path, new File([content], path.split('/').pop()!)]));

it('puts the files of a ZIP in its place, and leaves litter out', async () => {
  const sponza = zip({
    'sponza.obj': bytes('v 0 0 0'),
    'textures/': new Uint8Array(),
    'textures/wall.png': bytes('wall'),
    '__MACOSX/._sponza.obj': bytes('x'),
    '.DS_Store': bytes('x'),
  });
  const files = await expandZips(filesOf({ 'a/Sponza.ZIP': sponza, 'other.png': 'other' }));
  expect([...files.keys()]).toEqual(['other.png', 'a/Sponza/sponza.obj', 'a/Sponza/textures/wall.png']);
  const wall = files.get('a/Sponza/textures/wall.png')!;
  expect([wall.name, await wall.text()]).toEqual(['wall.png', 'wall']);
});

it('gives files without a ZIP back as they are', async () => {
  const files = filesOf({ 'a.obj': 'v' });
  expect(await expandZips(files)).toBe(files);
});

it('names a ZIP that is damaged', async () => {
  const cut = zip({ 'a.obj': bytes('v 0 0 0') }).slice(0, 40);
  await expect(expandZips(filesOf({ 'a.zip': cut }))).rejects.toThrow(/^a\.zip: The file is cut short or damaged/);
});
