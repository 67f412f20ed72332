import { Box3, Color, type DataTexture, MathUtils, PointLight, Vector3 } from 'three';
import { expect, it } from 'vitest';
import type { TracedLight } from '../scene/collectLights';
import { lightTable } from './lightTable';

function light(kind: TracedLight['kind'], position: Vector3, range: number): TracedLight {
  return {
    ...{ light: new PointLight(), kind, position, range, decay: 2, radius: 0, spotExponent: -1, isIndirect: false },
    ...{ direction: new Vector3(0, 0, 1), colour: new Color(), ambient: new Color(), attenuation: null },
    ...{ coneCosine: -2, penumbraCosine: -1, halfWidth: new Vector3(1, 0, 0), halfHeight: new Vector3(0, 1, 0) },
  };
}

const dataOf = (texture: DataTexture): Float32Array => texture.image.data as Float32Array;

it('no light that reaches a point is missing in the cell of that point, and few are there in vain', () => {
  MathUtils.seededRandom(5);
  const random = (): number => MathUtils.seededRandom();
  const bounds = new Box3(new Vector3(-3, 0, 2), new Vector3(9, 2.5, 7));
  const within = (margin: number): Vector3 =>
    new Vector3(random(), random(), random())
      .multiplyScalar(1 + 2 * margin)
      .subScalar(margin)
      .multiply(bounds.getSize(new Vector3()))
      .add(bounds.min);
  // some lights are outside of the bounds
  const reaching = Array.from({ length: 60 }, () =>
    light(random() < 0.5 ? 'point' : 'spot', within(0.3), 0.2 + 2 * random()),
  );
  const endless = [light('point', within(0), 0), light('rectangle', within(0), 0), light('directional', within(0), 0)];
  const all = [...reaching.slice(0, 30), ...endless, ...reaching.slice(30)];
  const table = lightTable(all, bounds);
  expect([table.count, table.endless]).toEqual([63, 3]);

  const [lights, cells, entries] = [table.lights, table.cells, table.cellLights].map(dataOf);
  const positionOf = (i: number): Vector3 => new Vector3().fromArray(lights, 36 * i);
  const order = Array.from({ length: 63 }, (_, i) =>
    all.find(({ position }) => position.distanceTo(positionOf(i)) < 1e-5)!,
  );
  expect(new Set(order).size, 'each light is in the table once').toBe(63);
  expect(order.slice(0, 3), 'lights without an end come first').toEqual(endless);

  let [listed, reached] = [0, 0];
  for (let n = 0; n < 4000; n++) {
    const point = within(0);
    const cell = point.clone().sub(table.least).multiply(table.scale).floor();
    const at = 4 * (cell.x + table.grid.x * (cell.y + table.grid.y * cell.z));
    const list = new Set(entries.subarray(cells[at], cells[at] + cells[at + 1]));
    for (let i = 3; i < order.length; i++) {
      const reaches = order[i].position.distanceTo(point) < order[i].range;
      if (reaches) expect(list.has(i), `light ${i} at ${point.toArray().join()}`).toBe(true);
      reached += Number(reaches);
    }
    listed += list.size;
  }
  expect(reached).toBeGreaterThan(1000);
  expect(listed / reached).toBeLessThan(1.6);
});

it('tells whether shadows have soft edges: of balls, of suns with a width, and of areas', () => {
  const bounds = new Box3(new Vector3(), new Vector3(1, 1, 1));
  const hard = light('point', new Vector3(), 1);
  const cases: [TracedLight[], boolean, boolean][] = [
    [[hard], false, true],
    [[{ ...hard, radius: 0.1 }], true, false],
    [[hard, light('tube', new Vector3(), 0)], true, true],
    [[light('disc', new Vector3(), 0)], true, false],
  ];
  for (const [lights, hasSoft, hasHard] of cases)
    expect(lightTable(lights, bounds)).toMatchObject({ hasSoft, hasHard });
});
