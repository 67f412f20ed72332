import { angle, boolean, choice, colour, euler, number, vector3 } from '@farol/editing/fields';
import { describe, expect, test } from 'vitest';
import '../components/index';
import { Light } from '../components/Light';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { serialize } from '../files/serialize';
import type { ClipData, ClipKey, ClipTrack } from '../assets/clips/ClipData';
import { ClipPreview } from './ClipPreview';
import { clipText } from '../assets/clips/clipText';
import { cubicBezier } from './cubicBezier';
import { parseClip } from '../assets/clips/parseClip';
import { objectAtPath, pathBelow } from './trackTarget';
import { valueAt } from './valueAt';

const track = (field: string, keys: ClipKey[], path = '', component = 'Transform'): ClipTrack => ({
  path,
  component,
  field,
  keys,
});

describe('parseClip', () => {
  test('reads what clipText writes, and the same text comes of it', () => {
    const clip: ClipData = {
      tracks: [
        track('position', [
          { time: 1 / 3, value: [Math.fround(0.1), 2, -0], easing: 'bezier', control: [0.42, 0, 0.58, 1] },
          { time: 1, value: [1e-7, 1 / 3, 5], easing: 'step' },
        ]),
        track('castShadows', [{ time: 0, value: true }], 'Arm/Hand', 'Light'),
      ],
      events: [{ time: 0.5, method: 'onStep', value: 3 }],
    };
    const text = clipText(clip);
    const read = parseClip(text);
    expect(clipText(read)).toBe(text);
    expect(read.tracks[1]).toEqual(clip.tracks[1]);
    expect(read.events).toEqual(clip.events);
    expect(read.tracks[0].keys[0].control).toEqual([0.42, 0, 0.58, 1]);
    expect(parseClip('')).toEqual({ tracks: [], events: [] });
  });

  test('every number of single precision stays itself', () => {
    const random = createRandom(7);
    const floats = new Float32Array(new Uint32Array(2000).map(() => random() * 2 ** 32).buffer).filter(Number.isFinite);
    const keys = [...floats].map((value, time) => ({ time, value }));
    const read = parseClip(clipText({ tracks: [track('intensity', keys, '', 'Light')], events: [] }));
    const back = Float32Array.from(read.tracks[0].keys, ({ value }) => value as number);
    expect(floats.length).toBeGreaterThan(1900);
    expect(back).toEqual(floats.map((value) => value + 0));
  });

  const broken = (keys: unknown, rest: object = {}): string =>
    JSON.stringify({ tracks: [{ path: 'Arm', component: 'Transform', field: 'position', keys, ...rest }] });

  test.each([
    ['{', /'Walk'.*not JSON/],
    ['[]', /'Walk'.*tracks and events/],
    ['{"tracks":{}}', /tracks must be a list/],
    ['{"tracks":[3]}', /track 1 must be an object/],
    ['{"events":[{"time":-1,"method":"a"}]}', /event 1: time/],
    ['{"events":[{"time":1,"method":""}]}', /event 1: method/],
    ['{"events":[{"time":1,"method":"a","value":{}}]}', /event 1: value/],
    [broken(3), /track 1 \('Arm', Transform\.position\): keys must be a list/],
    [broken([{ time: 'x', value: 1 }]), /track 1 \('Arm', Transform\.position\), key 1: time/],
    [broken([{ time: 0, value: [1, 2] }]), /key 1: value/],
    [broken([{ time: 0, value: 1, easing: 'jump' }]), /key 1: easing/],
    [broken([{ time: 0, value: 1, easing: 'bezier', control: [0, 0, 2, 1] }]), /key 1: x1 and x2/],
    [broken([{ time: 0, value: 1, easing: 'bezier', control: [0, 0] }]), /key 1: control/],
    [
      broken([
        { time: 1, value: 1 },
        { time: 1, value: 2 },
      ]),
      /key 2: its time \(1 s\)/,
    ],
    [
      broken([
        { time: 1, value: 1 },
        { time: 2, value: true },
      ]),
      /key 2: true is of another kind/,
    ],
    [broken([], { path: 3 }), /track 1: path/],
    [broken([], { component: null }), /track 1: component/],
    [broken([], { field: '' }), /track 1: field/],
    [JSON.stringify({ tracks: [track('position', []), track('position', [])] }), /track 2 .* is there twice/],
  ])('refuses %j', (text, message) => {
    expect(() => parseClip(text, 'Walk')).toThrow(message);
  });
});

describe('cubicBezier', () => {
  test('solves the curve to 1e-9 or better, steep ones and those that swing over too', () => {
    const random = createRandom(3);
    for (let i = 0; i < 20_000; i++) {
      const hard = i % 4 === 0;
      const x1 = hard ? Math.round(random()) : random();
      const x2 = hard ? Math.round(random()) : random();
      const y1 = random() * 4 - 2;
      const y2 = random() * 4 - 2;
      const t = random();
      const at = (a: number, b: number): number => 3 * (1 - t) ** 2 * t * a + 3 * (1 - t) * t * t * b + t ** 3;
      const slopeX = 3 * (1 - t) ** 2 * x1 + 6 * (1 - t) * t * (x2 - x1) + 3 * t * t * (1 - x2);
      // where the curve is vertical, time does not determine the value
      if (slopeX < 1e-3) continue;
      expect(Math.abs(cubicBezier(x1, y1, x2, y2, at(x1, x2)) - at(y1, y2))).toBeLessThan(1e-9);
    }
  });

  test('goes straight with straight handles, and is what CSS says of ease-in-out at a quarter', () => {
    expect(cubicBezier(1 / 3, 1 / 3, 2 / 3, 2 / 3, 0.7)).toBe(0.7);
    expect(cubicBezier(0.42, 0, 0.58, 1, 0.25)).toBeCloseTo(0.1291619, 6);
    expect([cubicBezier(0.4, 0, 0.6, 1, 0), cubicBezier(0.4, 0, 0.6, 1, 1)]).toEqual([0, 1]);
  });
});

describe('valueAt', () => {
  const help = '';
  test('holds the first and the last value, is exact at keys, and goes straight between them', () => {
    const position = track('position', [
      { time: 1, value: [0.1, 0, 0] },
      { time: 2, value: [0.3, 1, -4] },
    ]);
    const field = vector3([0, 0, 0], { help });
    expect(valueAt(position, field, 0)).toEqual([0.1, 0, 0]);
    expect(valueAt(position, field, 2)).toEqual([0.3, 1, -4]);
    expect(valueAt(position, field, 9)).toEqual([0.3, 1, -4]);
    expect(valueAt(position, field, 1.5)).toEqual([0.2, 0.5, -2]);
    expect(valueAt(track('position', []), field, 0)).toBeUndefined();
  });

  test('turns angles and eulers by their values, more than once round too', () => {
    const turn = track('rotation', [
      { time: 0, value: [0, 0, 0] },
      { time: 4, value: [0, Math.PI * 8, 0] },
    ]);
    expect(valueAt(turn, euler([0, 0, 0], { help }), 1)).toEqual([0, Math.PI * 2, 0]);
    const cutoff = track('cutoff', [
      { time: 0, value: 0 },
      { time: 1, value: 1 },
    ]);
    expect(valueAt(cutoff, angle(0, { help }), 0.25)).toBe(0.25);
  });

  test('steps flags and choices, and keeps ranges and whole numbers', () => {
    const keys = (a: never, b: never, rest: object = {}): ClipTrack =>
      track('x', [
        { time: 0, value: a, ...rest },
        { time: 1, value: b },
      ] as ClipKey[]);
    const swing = { easing: 'bezier', control: [0.5, 4, 0.5, -3] };
    expect(valueAt(keys(true as never, false as never), boolean(true, { help }), 0.99)).toBe(true);
    expect(valueAt(keys('a' as never, 'b' as never), choice('a', ['a', 'b'], { help }), 1)).toBe('b');
    expect(valueAt(keys(1 as never, 4 as never), number(0, { help, integer: true }), 0.5)).toBe(3);
    expect(valueAt(keys(0 as never, 1 as never, swing), number(0, { help, max: 1 }), 0.3)).toBe(1);
    const over = valueAt(keys([0, 0, 0] as never, [0.1, 1, 1] as never, swing), colour([0, 0, 0], { help }), 0.7);
    expect(Math.min(...(over as [number, number, number]))).toBe(0);
    expect(valueAt(keys(2 as never, 3 as never, { easing: 'step' }), number(0, { help }), 0.9)).toBe(2);
  });
});

test('a path of names leads to an object and back, with slashes in names too', () => {
  const [root, arm, slashed, hand, twin] = ['Robot', 'Arm', 'Left/Arm', 'Hand', 'Hand'].map(
    (name) => new GameObject(name),
  );
  root.add(arm).add(slashed);
  slashed.add(hand).add(twin);
  expect(pathBelow(root, hand)).toBe('Left/Arm/Hand');
  expect(objectAtPath(root, 'Left/Arm/Hand')).toBe(hand);
  expect(objectAtPath(root, '')).toBe(root);
  expect(objectAtPath(root, 'Arm/Hand')).toBeNull();
  expect([pathBelow(root, twin), pathBelow(arm, hand), pathBelow(root, root)]).toEqual([null, null, '']);
});

test('a preview shows a clip at a time, says what is gone, and ends without a trace', () => {
  const scene = new Scene();
  const root = new GameObject('Door');
  const light = root.addComponent(Light, { intensity: 2 });
  root.transform.rotation = [0.1, 0.2, 0.3];
  scene.add(root);
  const before = JSON.stringify(serialize(scene));
  const { revision } = scene;
  const matrix = root.transform.modelMatrix.elements;
  const tracks = [
    track('rotation', [
      { time: 0, value: [0, 0, 0] },
      { time: 1, value: [0, 1, 0] },
    ]),
    track('intensity', [{ time: 0, value: 7 }], '', 'Light'),
    track('position', [{ time: 0, value: [1, 1, 1] }], 'Handle'),
  ];
  const preview = new ClipPreview(root);
  expect(preview.show({ tracks, events: [] }, 0.5)).toEqual([expect.stringMatching(/'Door\/Handle' is gone/)]);
  expect([root.transform.rotation[1], light.intensity]).toEqual([0.5, 7]);
  preview.show({ tracks: tracks.slice(0, 1), events: [] }, 0);
  expect(light.intensity).toBe(2);
  preview.end();
  expect([light.intensity, light.three.intensity]).toEqual([2, 2]);
  expect(root.transform.modelMatrix.elements).toEqual(matrix);
  expect(JSON.stringify(serialize(scene))).toBe(before);
  expect(scene.revision).toBe(revision);
});
