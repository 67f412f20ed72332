import { workOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { parsePly } from '../../geometry/parsePly';
import { packObj } from '../packObj';
import { decodeTga } from './decodePicture';
import { ObjFolder } from './ObjFolder';

/** Greatest number of steps per character of a file: reading takes linear time. */
const STEPS = 20;

/** Runs a reader, and checks its steps against the number of characters. */
async function inSteps<T>(letters: number, run: () => T | Promise<T>): Promise<Awaited<T>> {
  let result: Awaited<T>;
  const work = await workOf(async () => (result = await run()));
  expect(work).toBeLessThan(STEPS * letters);
  return result!;
}

const pack = (name: string, text: string) => packObj(new Map([[name, new File([text], name)]]), name);
const packInSteps = (text: string) => inSteps(text.length, () => pack('a.obj', text));
const failure = async (run: () => Promise<unknown>): Promise<string> => {
  try {
    await run();
  } catch (error) {
    return (error as Error).message;
  }
  throw new Error('It was taken.');
};

const corners = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';

test('an STL of beginnings without an end', async () => {
  for (const text of [`solid a\n${'facet '.repeat(200_000)}\nendsolid`, 'solid a\n'.repeat(100_000)]) {
    expect(await inSteps(text.length, () => failure(() => pack('a.stl', text)))).toMatch(/it has no triangles/);
  }
});

test('a text STL is read whatever its letters, names and line ends are', async () => {
  const facet = 'facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1e0 0 endloop endfacet';
  for (const text of [
    `solid solid vertex of a facet\n${facet.replaceAll(/ (?=[a-z])/g, '\n')}\nendsolid solid vertex of a facet\n`,
    `solid\r\n${facet.toUpperCase().replaceAll(/ (?=[A-Z])/g, '\r\n\t')}\r\nendsolid`,
    `solid a ${facet} endsolid a`,
  ]) {
    const { glb } = await pack('a.stl', text);
    expect(new TextDecoder().decode(glb)).toMatch(/"count":3,"type":"VEC3".*"max":\[1,1,0\]/);
  }
});

test('an OBJ whose names are long, one vertex with many textures', async () => {
  const long = 'x'.repeat(100_000);
  const faces = 'f 1 2 3\n'.repeat(5000);
  const { glb } = await packInSteps(`o ${long}\n${corners}usemtl ${long}\n${faces}usemtl ${long}\n${faces}`);
  // one mesh of one material; its name is shortened
  expect(glb.byteLength).toBeLessThan(500_000);
  const count = 18_000;
  const places = Array.from({ length: count / 3 }, (_, i) => `f 1/${3 * i + 1} 1/${3 * i + 2} 1/${3 * i + 3}\n`);
  await packInSteps(`v 0 0 0\n${'vt 0 0\n'.repeat(count)}${places.join('')}`);
});

test('a face of very many corners that is not convex', async () => {
  const comb = (count: number): string => {
    const there = Array.from({ length: count / 2 }, (_, i) => `v ${i} ${i % 2} 0\n`);
    const back = there.map((_, i) => `v ${count / 2 - i} ${(i % 2) - 2} 0\n`);
    return `${[...there, ...back].join('')}f ${Array.from({ length: count }, (_, i) => i + 1).join(' ')}\n`;
  };
  const { notes } = await packInSteps(comb(10_000));
  expect(notes).toContain(
    'a.obj: 1 of its faces have so many corners that they may look wrong: cut them into triangles.',
  );
  // rounding makes a circle slightly concave
  const round = Array.from({ length: 5000 }, (_, i) => `v ${Math.cos(i / 1000)} ${Math.sin(i / 1000)} 0\n`);
  await packInSteps(`${round.join('')}f ${round.map((_, i) => i + 1).join(' ')}\n`);
});

test('very many textures among very many files', async () => {
  const folder = new ObjFolder(
    new Map(Array.from({ length: 2000 }, (_, i) => [`room/textures ${i}/Wall.PNG`, new File([], 'Wall.PNG')] as const)),
  );
  const count = 2000;
  const found = await inSteps(40 * count, () =>
    Array.from({ length: count }, (_, i) => folder.find('room/a.mtl', `C:\\maps\\textures ${i}\\wall.png`)),
  );
  expect(found[1999]).toBe('room/textures 1999/Wall.PNG');
  expect(new ObjFolder(new Map([['a/..', new File([], '..')]])).ending('.mtl', 'a.obj')).toEqual([]);
  expect(folder.find('room/a.mtl', `${'a/'.repeat(100_000)}wall.png`)).toBe('room/textures 0/Wall.PNG');
});

test('a PLY whose elements cannot all be in it', async () => {
  const head = 'ply\nformat binary_little_endian 1.0\n';
  const text = `${head}${'element x 3000000\n'.repeat(200)}end_header\n${' '.repeat(3_000_000)}`;
  const bytes = new TextEncoder().encode(text).buffer as ArrayBuffer;
  expect(await inSteps(text.length, () => failure(() => parsePly(bytes)))).toMatch(
    /is too short for 3000000 of the element x/,
  );
});

test('a TGA that would take absurd memory', () => {
  // a packed TGA without data: only the size in its header counts
  const bytes = new Uint8Array(18);
  bytes.set([0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x40, 0, 0x40, 32, 8]);
  expect(() => decodeTga(bytes)).toThrow(/16384 × 16384 pixels/);
});
