import type { Mesh } from 'three';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../base/createRandom';
import { runSteps } from '../../base/steps';
import { parseObj } from './parseObj';

const read = (text: string) => runSteps(parseObj(new TextEncoder().encode(text)));
const trianglesOf = (text: string): number[][] => {
  const { corners } = read(text);
  return Array.from({ length: corners.length / 9 }, (_, i) => [0, 3, 6].map((k) => corners[i * 9 + k]));
};
const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';

describe('parseObj', () => {
  it('reads vertices, texture coordinates, normals and every form of a corner', () => {
    const file = read(`${square}vt 0.5 .25\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1`);
    expect([...file.positions.slice(3, 9)]).toEqual([1, 0, 0, 1, 1, 0]);
    expect([...file.uvs]).toEqual([0.5, 0.25]);
    expect([...file.normals]).toEqual([0, 0, 1]);
    const first = [0, 9, 18, 27].map((at) => [...file.corners.slice(at, at + 3)]);
    expect(first).toEqual([
      [0, -1, -1],
      [0, 0, -1],
      [0, -1, 0],
      [0, 0, 0],
    ]);
  });

  it('reads numbers of every form to the nearest single', () => {
    const numbers = ['1', '-2.5', '+.125', '3.', '1e3', '-1.5E-7', '0.1', '123456.789', '3.14159265358979', '1e-40'];
    for (const text of numbers) {
      expect(read(`v ${text} 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3`).positions[0], text).toBe(Math.fround(Number(text)));
    }
  });

  it('counts negative indices from the end, and finds vertices that come after their face', () => {
    expect(trianglesOf(`${square}f -4 -3 -2\nv 9 9 9\nf -5 -2 -1`)).toEqual([
      [0, 1, 2],
      [0, 3, 4],
    ]);
    expect(trianglesOf(`f 1 2 3\n${square}`)).toEqual([[0, 1, 2]]);
  });

  it('counts negative texture coordinates and normals each from the end of their own list', () => {
    const { corners } = read(`${square}vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nf -4/-3/-1 -3/-2/-1 -2/-1/-1`);
    expect([...corners]).toEqual([0, 0, 0, 1, 1, 0, 2, 2, 0]);
  });

  it('takes breaks of lines of all systems, comments, blanks, tabs and lines that go on', () => {
    const plain = trianglesOf(`${square}f 1 2 3 4\n`);
    expect(plain).toHaveLength(2);
    expect(trianglesOf(`${square}f 1 2 3 4`.replaceAll('\n', '\r\n'))).toEqual(plain);
    expect(trianglesOf(`${square}f 1 2 3 4`.replaceAll('\n', '\r'))).toEqual(plain);
    expect(
      trianglesOf(`\ufeff# a square\n\n  ${square.replaceAll(' ', '\t ')}f 1 2 \\\n 3 4  # end`.replace('  # end', '')),
    ).toEqual(plain);
    expect(trianglesOf(`${square}f 1 2 \\\r\n3 \\\r\n 4`)).toEqual(plain);
  });

  it('cuts a polygon that is not convex within itself, and keeps how it turns', () => {
    // an arrowhead: four corners, the third of them concave; then an L of six
    const arrow = 'v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\n';
    const ell = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n';
    for (const [text, face, area] of [
      [arrow, 'f 1 2 3 4', 1],
      [arrow, 'f 2 3 4 1', 1],
      [arrow, 'f 4 3 2 1', -1],
      [ell, 'f 1 2 3 4 5 6', 3],
      [ell, 'f 3 4 5 6 1 2', 3],
      [ell, 'f 6 5 4 3 2 1', -3],
    ] as const) {
      const { positions } = read(text + face);
      const areas = trianglesOf(text + face).map(([a, b, c]) => {
        const [ax, ay, bx, by, cx, cy] = [a, b, c].flatMap((v) => [positions[v * 3], positions[v * 3 + 1]]);
        return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
      });
      expect(
        areas.reduce((sum, each) => sum + each, 0),
        face,
      ).toBeCloseTo(area, 6);
      for (const each of areas) expect(each * area, `${face}: a triangle turns the other way`).toBeGreaterThan(0);
    }
  });

  it('tells groups, objects and materials apart, and joins what goes on', () => {
    const file = read(
      `mtllib my rooms.mtl\n${square}o room\ng wall\nusemtl brick\nf 1 2 3\nf 1 3 4\nusemtl moss\nf 1 2 3\ng\nf 1 2 3\no hall\ng wall\nf 1 2 3`,
    );
    expect(file.materialFiles).toEqual(['my rooms.mtl']);
    expect(file.runs.map(({ name, material, from, to }) => [name, material, from, to])).toEqual([
      ['wall', 'brick', 0, 6],
      ['wall', 'moss', 6, 9],
      ['room', 'moss', 9, 12],
      ['wall', 'moss', 12, 15],
    ]);
    expect(file.runs[0].key).not.toBe(file.runs[3].key);
  });

  it('reads colours of vertices as sRGB, with and without a weight', () => {
    const { colours } = read('v 0 0 0 1 0.5 0\nv 1 0 0 1 0 1 0\nv 0 1 0\nf 1 2 3');
    expect(colours![1]).toBeCloseTo(0.214, 3);
    expect([...colours!.slice(3)]).toEqual([0, 1, 0, 1, 1, 1]);
    expect(read(`${square}f 1 2 3`).colours).toBeNull();
  });

  it('leaves lines, points and keywords that it does not know out', () => {
    const file = read(`${square}vp 1 2\ns 1\nlod 3\nl 1 2 3\np 1\nf 1 2\nf 1 2 3`);
    expect(file.leftOut).toBe(2);
    expect(file.corners.length).toBe(9);
  });

  it.each([
    ['', /no vertices/],
    ['<html>not found</html>', /no vertices/],
    [square, /no faces/],
    [`${square}f 1 2 9`, /^line 5: a face names vertex 9, and the file has 4: export it again\.$/],
    [`${square}\n\nf 1 2 -5`, /^line 7: .*names a vertex that does not exist/],
    [`${square}f 0 1 2`, /^line 5: .*names a vertex that does not exist/],
    [`${square}f 1 2 x`, /^line 5: .*does not exist/],
    [`${square}f 1,1 2,2 3,3`, /^line 5: .*vertex\/texture\/normal/],
    ['v 0 0 0\nv 1,5 0 0', /^line 2: the vertex does not have three numbers/],
    ['v 0 0', /^line 1: the vertex does not have three numbers/],
    ['v nan 0 0', /^line 1: the vertex does not have three numbers/],
    [`${square}f 1 2 \\\n 9 \\\n 1 \n`, /^line \d: a face names vertex 9/],
  ])('says what is wrong (%#)', (text, message) => {
    expect(() => read(text)).toThrow(message);
  });

  it("agrees with three's OBJLoader on random files of convex faces", () => {
    const random = createRandom(15);
    const whole = (most: number): number => Math.floor(random() * most);
    const lines: string[] = [];
    let vertices = 0;
    for (let face = 0; face < 200; face++) {
      if (face % 17 === 0) lines.push(`g part ${face}`);
      if (face % 11 === 0) lines.push(`usemtl material${whole(3)}`);
      const count = 3 + whole(5);
      for (let i = 0; i < count; i++) {
        const angle = (i / count) * 2 * Math.PI;
        lines.push(
          `v ${Math.cos(angle).toFixed(6)} ${Math.sin(angle).toExponential(5)} ${random() < 0.5 ? face : -face}`,
        );
        lines.push(`vt ${random()} ${random()}`, `vn ${random()} ${random()} 1`);
      }
      vertices += count;
      const index = (i: number): number => (face % 2 === 0 ? vertices - count + i + 1 : i - count);
      lines.push(`f ${Array.from({ length: count }, (_, i) => `${index(i)}/${index(i)}/${index(i)}`).join(' ')}`);
    }
    // each face is planar, so that both fans are equal
    const text = lines.join('\n').replaceAll(/ (-?)(\d+)$/gm, ' $2');
    const { positions, uvs, normals, corners } = read(text);
    const flat = (source: Float32Array, size: number, offset: number): number[] =>
      Array.from({ length: corners.length / 3 }, (_, i) => [
        ...source.slice(corners[i * 3 + offset] * size, corners[i * 3 + offset] * size + size),
      ]).flat();
    const meshes = new OBJLoader().parse(text).children as Mesh[];
    const theirs = (name: string): number[] => meshes.flatMap(({ geometry }) => [...geometry.getAttribute(name).array]);
    expect(flat(positions, 3, 0)).toEqual(theirs('position'));
    expect(flat(uvs, 2, 1)).toEqual(theirs('uv'));
    expect(flat(normals, 3, 2)).toEqual(theirs('normal'));
  });
});
