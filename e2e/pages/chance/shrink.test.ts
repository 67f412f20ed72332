import { expect, it } from 'vitest';
import { chooseScene } from './chooseScene';
import { kindOf } from './kindOf';
import type { SceneFacts } from './SceneFacts';
import { shrink } from './shrink';

const scene: SceneFacts = {
  world: { background: 0xff, fog: { near: 1 } },
  things: [{ material: { type: 'MeshLambertMaterial', dithering: true } }, { position: [1, 2, 3] }, { as: 'points' }],
  lights: [{ kind: 'point', count: 40 }, { kind: 'ambient' }],
};

it('leaves what the fault needs', () => {
  const least = shrink(scene, ({ things = [] }) => things.some(({ material }) => material?.dithering === true));
  expect(least).toEqual({ things: [{ material: { dithering: true } }] });
});

it('leaves a vector whole, and takes halves of a count', () => {
  const least = shrink(
    scene,
    ({ things = [], lights = [] }) => things.some((thing) => thing.position) && (lights[0]?.count ?? 0) > 2,
  );
  expect(least).toEqual({ things: [{ position: [1, 2, 3] }], lights: [{ count: 5 }] });
});

it('leaves a fault of two parts that are far apart', () => {
  const least = shrink(scene, ({ world, things = [] }) => Boolean(world?.fog) && things.some(({ as }) => as));
  expect(least).toEqual({ world: { fog: {} }, things: [{ as: 'points' }] });
});

it('asks no more often than it may', () => {
  let asked = 0;
  shrink(scene, () => ++asked < 0, 5);
  expect(asked).toBe(5);
});

it('names the kind of a fault by what is left', () => {
  const least = {
    view: { depth: 'reversed' },
    world: { shadows: 'vsm' },
    things: [{}],
    lights: [{ shadow: {} }],
  } as const;
  expect(kindOf(least)).toBe('depth reversed, shadows vsm, light point, light shadow');
});

it('chooses by the seed alone, and has JSON say all of it', () => {
  for (const seed of [0, 1, 77, 1999]) {
    const facts = chooseScene(seed);
    expect(chooseScene(seed)).toEqual(facts);
    expect(JSON.parse(JSON.stringify(facts))).toEqual(facts);
    expect(chooseScene(seed + 1)).not.toEqual(facts);
  }
});
