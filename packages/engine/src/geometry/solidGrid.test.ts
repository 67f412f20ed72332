import { Vector3, type BufferGeometry } from 'three';
import { expect, test } from 'vitest';
import { createRandom } from '../base/createRandom';
import { solidGrid } from './solidGrid';

/** Volume by the divergence theorem, area, and whether each edge occurs equally often in both directions. */
function measure(geometry: BufferGeometry): { volume: number; area: number; isClosed: boolean } {
  const positions = geometry.getAttribute('position');
  const normals = geometry.getAttribute('normal');
  const indices = geometry.getIndex()!.array;
  const edges = new Map<string, number>();
  const name = (v: Vector3): string => v.toArray().join(' ');
  let volume = 0;
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => new Vector3().fromBufferAttribute(positions, indices[i + k]));
    const across = b.clone().sub(a).cross(c.clone().sub(a));
    expect(across.clone().normalize().dot(new Vector3().fromBufferAttribute(normals, indices[i]))).toBeCloseTo(1, 6);
    volume += a.dot(b.clone().cross(c)) / 6;
    area += across.length() / 2;
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ]) {
      const [first, second] = [name(from), name(to)];
      const [key, sign] = first < second ? [`${first}/${second}`, 1] : [`${second}/${first}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + sign);
    }
  }
  return { volume, area, isClosed: [...edges.values()].every((sum) => sum === 0) };
}

test('the surface of solid cells is closed, faces out, and holds their volume: 200 random grids', () => {
  const random = createRandom(11);
  for (let round = 0; round < 200; round++) {
    const planes = [0, 1, 2].map(() => [0, 1, 2, 3].map((i) => i + 0.8 * random())) as [number[], number[], number[]];
    const solid = new Map<string, boolean>();
    let wanted = 0;
    const geometry = solidGrid(planes, (middle) => {
      const isSolid = random() < 0.6;
      solid.set(middle.join(' '), isSolid);
      if (isSolid) {
        wanted += planes
          .map((lines, axis) => {
            const i = lines.findIndex((at, k) => at < middle[axis] && middle[axis] < lines[k + 1]);
            return lines[i + 1] - lines[i];
          })
          .reduce((product, length) => product * length, 1);
      }
      return isSolid;
    });
    expect(solid.size).toBe(27);
    const { volume, isClosed } = measure(geometry);
    expect(isClosed).toBe(true);
    expect(volume).toBeCloseTo(wanted, 4);
  }
});

test('planes may stand in any order and twice, and nothing solid gives nothing', () => {
  const box = solidGrid(
    [
      [2, 0, 2],
      [0, 1, 1 + 1e-9],
      [3, 0],
    ],
    () => true,
  );
  expect(box.getAttribute('position').count).toBe(24);
  expect(measure(box)).toMatchObject({ volume: expect.closeTo(6, 6), area: expect.closeTo(22, 6) });
  expect(
    solidGrid(
      [
        [0, 1],
        [0, 1],
        [0, 1],
      ],
      () => false,
    ).getAttribute('position').count,
  ).toBe(0);
});

test('texture coordinates are metres, upright on walls', () => {
  const box = solidGrid(
    [
      [0, 4],
      [0, 2.5],
      [0, 0.2],
    ],
    () => true,
  );
  const [uvs, normals, positions] = ['uv', 'normal', 'position'].map((name) => box.getAttribute(name));
  const upright = Array.from({ length: uvs.count }, (_, i) => i).filter((i) => normals.getY(i) === 0);
  expect(upright).toHaveLength(16);
  expect(upright.map((i) => uvs.getY(i))).toEqual(upright.map((i) => positions.getY(i)));
});
