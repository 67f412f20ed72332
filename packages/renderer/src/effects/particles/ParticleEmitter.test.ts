import { BoxGeometry, Mesh, Object3D, Texture, Vector3 } from 'three';
import { expect, test, vi } from 'vitest';
import { settingNames } from './checkParticleSetting';
import { particleDefaults } from './particleDefaults';
import { ParticleEmitter } from './ParticleEmitter';
import { particlePresets } from './particlePresets';
import type { ParticleSettings } from './ParticleSettings';

test('each setting is a property with its default, and can be given to the constructor', () => {
  expect(settingNames.toSorted()).toEqual(Object.keys(particleDefaults).toSorted());
  expect(new ParticleEmitter().settings).toEqual(particleDefaults);
  const given = new ParticleEmitter({ rate: 7, shape: { kind: 'point' }, receiveShadow: true, lightEvery: 3 });
  expect(given.settings).toEqual({
    ...particleDefaults,
    rate: 7,
    shape: { kind: 'point' },
    receiveShadow: true,
    lightEvery: 3,
  });
  for (const preset of Object.values(particlePresets))
    expect(new ParticleEmitter(preset).settings).toMatchObject(preset);
});

const wrong: readonly (readonly [keyof ParticleSettings, unknown, string])[] = [
  ['capacity', 0, 'capacity is 0; give a whole number from 1 to 1048576.'],
  ['capacity', 2 ** 20 + 1, 'capacity is 1048577; give a whole number from 1 to 1048576.'],
  ['capacity', 1.5, 'capacity is 1.5; give a whole number from 1 to 1048576.'],
  ['seed', Infinity, 'seed is Infinity; give a finite number.'],
  ['rate', Number.NaN, 'rate is NaN; give a number of at least 0.'],
  ['rate', -1, 'rate is -1; give a number of at least 0.'],
  ['prewarm', 61, 'prewarm is 61; give a number from 0 to 60.'],
  ['life', [2, 1], 'life is [2,1]; give two numbers above 0, the first at most the second.'],
  ['life', [0, 1], 'life is [0,1]; give two numbers above 0, the first at most the second.'],
  ['speed', [1, Number.NaN], 'speed is [1,"NaN"]; give two finite numbers, the first at most the second.'],
  ['gravity', [0, 1], 'gravity is [0,1]; give three finite numbers.'],
  ['loop', 1, 'loop is 1; give true or false.'],
  ['bursts', [{ time: 0, count: 1.5 }], 'give a list of bursts, each of a time of at least 0 and a whole count.'],
  ['shape', { kind: 'sphere', radius: -1, thickness: 0 }, 'give a sphere with a radius of at least 0'],
  [
    'shape',
    { kind: 'cone', radius: 1, angle: 2 },
    'give a cone with a radius of at least 0 and an angle from 0 to π/2.',
  ],
  ['shape', { kind: 'box', size: [1, 1, -1] }, 'give a box with three sides of at least 0.'],
  ['shape', { kind: 'mesh', mesh: {} }, 'give a mesh shape whose mesh is a Mesh or null.'],
  ['shape', { kind: 'star' }, 'give a shape of the kind point, sphere, cone, box or mesh.'],
  ['colliders', [{ kind: 'plane', normal: [0, 0, 0], height: 0, bounce: 0, friction: 0 }], 'a normal that is not zero'],
  ['colliders', [{ kind: 'sphere', center: [0, 0, 0], radius: 0, bounce: 0, friction: 0 }], 'a radius above 0'],
  [
    'colliders',
    Array.from({ length: 5 }, () => ({ kind: 'sphere', center: [0, 0, 0], radius: 1, bounce: 0, friction: 0 })),
    'at most 4',
  ],
  ['sizeOverLife', [], 'sizeOverLife is []; give at least one key of a time from 0 to 1, ascending'],
  ['sizeOverLife', [[0.5, 1], [0.4, 1]], 'ascending, and a finite number.'], // prettier-ignore
  ['colorOverLife', [[0, [1, 1, 1], 2]], 'a colour of three numbers of at least 0, and an opacity from 0 to 1.'],
  ['texture', {}, 'give null or a Texture.'],
  ['flipBook', { columns: 0, rows: 1 }, 'give null or a flip-book with at least one column and row'],
  ['render', 'sprite', 'render is "sprite"; give one of: billboard, stretched, mesh.'],
  ['blending', null, 'blending is null; give one of: blended, additive, weighted.'],
  ['lightEvery', 0.5, 'lightEvery is 0.5; give a whole number from 0 to 1048576.'],
  ['lightRange', -1, 'lightRange is -1; give a number of at least 0.'],
];

test.each(wrong)('%s of %j is refused where it is set, and the value before it stays', (name, value, message) => {
  const emitter = new ParticleEmitter();
  emitter.name = 'Torch';
  const before = emitter[name];
  const set = () => ((emitter as unknown as Record<string, unknown>)[name] = value);
  expect(set).toThrow(RangeError);
  expect(set).toThrow('ParticleEmitter "Torch": ');
  expect(set).toThrow(message);
  expect(emitter[name]).toBe(before);
});

test('a name that no setting has is refused, and nothing is set', () => {
  const emitter = new ParticleEmitter({ rate: 7 });
  expect(() => emitter.set({ rate: 9, rat: 3 } as object)).toThrow(
    /^ParticleEmitter: "rat" is no setting; the settings are .*\brate\b/,
  );
  expect(emitter.rate).toBe(7);
  expect(() => new ParticleEmitter({ toString: 1 } as object)).toThrow('"toString" is no setting');
});

test('a step must be a finite number of seconds', () => {
  const emitter = new ParticleEmitter();
  expect(() => emitter.step(Number.NaN)).toThrow('step(NaN); give a finite number of seconds of at least 0.');
  expect(() => emitter.step(-1)).toThrow(RangeError);
});

test('time goes by steps, and begins anew with another capacity, seed or shape', () => {
  const emitter = new ParticleEmitter({ prewarm: 2, rate: 10 });
  emitter.step(0.5);
  emitter.step(0.25);
  expect(emitter.time).toBeCloseTo(0.75, 9);
  expect(emitter.pending.schedule.begun).toBe(27); // including those of prewarm
  emitter.rate = 20;
  expect(emitter.time).toBeCloseTo(0.75, 9);
  for (const change of [{ capacity: 5 }, { seed: 9 }, { shape: { kind: 'point' } }] as const) {
    emitter.set(change);
    expect(emitter.time).toBe(0);
    emitter.step(0.125);
    expect(emitter.time).toBeCloseTo(0.125, 9);
  }
});

test('steps go from transform to transform, and those of which nothing lives are let go while nobody draws', () => {
  const parent = new Object3D();
  const emitter = new ParticleEmitter({ life: [0.1, 0.2] });
  parent.add(emitter);
  emitter.step(0.01);
  parent.position.x = 6;
  emitter.step(0.1);
  const { pending } = emitter;
  const places = pending.steps
    .slice(0, pending.count)
    .map(({ matrix }) => new Vector3().setFromMatrixPosition(matrix).x);
  expect(places).toEqual([0, 2, 4, 6].map((x) => expect.closeTo(x, 9)));
  for (let i = 0; i < 9000; i++) emitter.step(0.01);
  expect(pending.count).toBeLessThanOrEqual(4096);
  expect(pending.steps.length).toBeLessThanOrEqual(4096);
  expect(pending.clears).toBe(true);
  const kept = pending.steps.slice(0, pending.count).map(({ time }) => time);
  expect(kept).toEqual(kept.toSorted((a, b) => a - b));
  expect(kept.at(-1)).toBeCloseTo(emitter.time, 6);
});

test('every nth particle is a light of its field, which stays where it is while the emitter moves', () => {
  const emitter = new ParticleEmitter({ capacity: 100 });
  expect(emitter.lights).toBeNull();
  emitter.lightEvery = 8;
  expect(emitter.lights).toMatchObject({ isLightField: true, capacity: 13, count: 13 });
  emitter.position.set(1, 2, 3);
  emitter.updateMatrixWorld();
  expect(emitter.lights!.matrixWorld.elements.slice(12)).toEqual([0, 0, 0, 1]);
  emitter.capacity = 800;
  expect(emitter.children).toEqual([emitter.lights]);
  expect(emitter.lights!.capacity).toBe(100);
  emitter.lightEvery = 0;
  expect(emitter.children).toEqual([]);
});

test('a clone has the settings and children of its own', () => {
  const texture = new Texture();
  const emitter = new ParticleEmitter({ texture, lightEvery: 2, render: 'mesh', particleGeometry: new BoxGeometry() });
  emitter.position.x = 4;
  emitter.add(new Mesh());
  const clone = emitter.clone();
  expect(clone.settings).toEqual(emitter.settings);
  expect(clone.position.x).toBe(4);
  expect(clone.geometry).not.toBe(emitter.geometry);
  expect(clone.children.map(({ type }) => type).toSorted()).toEqual(['LightField', 'Mesh']);
  expect(clone.lights).not.toBe(emitter.lights);
});

test('a capacity that is reached is told once, with one that is enough', () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const emitter = new ParticleEmitter({ capacity: 5, rate: 10, life: [1, 2] });
  emitter.name = 'Smoke';
  for (let i = 0; i < 40; i++) emitter.step(0.1);
  emitter.restart();
  for (let i = 0; i < 40; i++) emitter.step(0.1);
  expect(warn.mock.calls).toEqual([
    ['ParticleEmitter "Smoke": capacity 5 is reached, and no more particles begin; set it to 20 or more.'],
  ]);
  warn.mockRestore();
});
