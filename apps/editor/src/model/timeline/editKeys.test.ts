import { type ClipData, type ClipKey, clipText, createRandom, parseClip } from '@farol/engine';
import { describe, expect, test } from 'vitest';
import { clipDataOf, writeClip } from './clipDataOf';
import { keyId, type TrackAddress, trackId, valueAt } from './clipTracks';
import { copyKeys, pasteKeys, readCopiedKeys } from './copyKeys';
import { curveAt, splitCurve } from './easingCurve';
import { addEvent, changeEvent, moveEvents, removeEvents } from './editEvents';
import {
  allKeys,
  deleteKeys,
  easeKeys,
  keptSelection,
  moveKeys,
  rangeOfKeys,
  removeTracks,
  retargetTrack,
  scaleKeys,
  setKey,
  setValuesOfKeys,
} from './editKeys';

const place: TrackAddress = { path: '', component: 'Transform', field: 'position' };
const glow: TrackAddress = { path: 'Lamp', component: 'Light', field: 'intensity' };

const numbers = (...times: number[]): ClipKey[] => times.map((time) => ({ time, value: time * 10 }));

const clipOf = (...keys: ClipKey[]): ClipData => ({ tracks: [{ ...glow, keys }], events: [] });

const ids = (...times: number[]): Set<string> => new Set(times.map((time) => keyId(trackId(glow), time)));

const timesOf = (data: ClipData): number[] => data.tracks[0].keys.map(({ time }) => time);

describe('setKey', () => {
  test('makes a track, puts keys in order, and changes the one that is there', () => {
    let data = setKey({ tracks: [], events: [] }, place, 1, [1, 2, 3]);
    data = setKey(data, place, 0, [0, 0, 0]);
    data = setKey(data, place, 0.5, [5, 5, 5]);
    data = setKey(data, place, 1.000001, [9, 9, 9]);
    expect(data.tracks).toEqual([
      {
        ...place,
        keys: [
          { time: 0, value: [0, 0, 0] },
          { time: 0.5, value: [5, 5, 5] },
          { time: 1, value: [9, 9, 9] },
        ],
      },
    ]);
  });

  test('leaves a track that is not there alone without a value, and the clip it was given as it was', () => {
    const data = clipOf(...numbers(0, 1));
    expect(setKey(data, place, 0.5)).toBe(data);
    setKey(data, glow, 0.5);
    expect(timesOf(data)).toEqual([0, 1]);
  });

  test('keeps the easing of the way that it parts', () => {
    const step = setKey(clipOf({ time: 0, value: 1, easing: 'step' }, { time: 1, value: 2 }), glow, 0.5);
    expect(step.tracks[0].keys[1]).toEqual({ time: 0.5, value: 1, easing: 'step' });
    const last = setKey(clipOf({ time: 0, value: 1, easing: 'bezier' }), glow, 1, 4);
    expect(last.tracks[0].keys[1]).toEqual({ time: 1, value: 4, easing: 'bezier' });
  });

  test('a key on a Bézier curve leaves the curve as it is, of vectors too', () => {
    const random = createRandom(11);
    for (let i = 0; i < 60; i++) {
      // handles that cross far in time cannot be split exactly, see splitCurve
      const control = [random() * 0.7, random() * 3 - 1, 0.3 + random() * 0.7, random() * 3 - 1] as const;
      const keys: ClipKey[] = [
        { time: 1, value: [0, 5, -2], easing: 'bezier', control },
        { time: 3, value: [4, 5, 7] },
      ];
      const at = 1.1 + random() * 1.8;
      const data = setKey({ tracks: [{ ...place, keys }], events: [] }, place, at);
      const split = data.tracks[0].keys;
      expect(split).toHaveLength(3);
      for (let time = 1; time <= 3; time += 0.05) {
        const [before, after] = [valueAt(keys, time), valueAt(split, time)] as unknown as number[][];
        before.forEach((value, axis) => expect(Math.abs(after[axis] - value)).toBeLessThan(1e-7));
      }
    }
  });
});

test('a curve is parted at its place, and both parts are within what a clip allows', () => {
  const { way, before } = splitCurve(0.5, [0.42, 0, 0.58, 1]);
  expect(way).toBeCloseTo(0.5, 12);
  for (const share of [0.01, 0.3, 0.5, 0.9, 0.999]) {
    const parts = splitCurve(share, [1, 0, 0, 1]);
    for (const [x1, , x2] of [parts.before, parts.after]) {
      expect(Math.min(x1, x2)).toBeGreaterThanOrEqual(0);
      expect(Math.max(x1, x2)).toBeLessThanOrEqual(1);
    }
  }
  expect(curveAt(0.5, before) * way).toBeCloseTo(curveAt(0.25, [0.42, 0, 0.58, 1]), 6);
});

describe('moveKeys', () => {
  test('moves what is selected, and what is met gives way', () => {
    const { data, selected } = moveKeys(clipOf(...numbers(0, 1, 2, 3)), ids(0, 1), 2);
    expect(data.tracks[0].keys).toEqual([
      { time: 2, value: 0 },
      { time: 3, value: 10 },
    ]);
    expect(selected).toEqual(ids(2, 3));
  });

  test('keeps distances at the beginning', () => {
    const { data, selected } = moveKeys(clipOf(...numbers(1, 2)), ids(1, 2), -5);
    expect(timesOf(data)).toEqual([0, 1]);
    expect(selected).toEqual(ids(0, 1));
  });

  test('passes keys that stay', () => {
    expect(moveKeys(clipOf(...numbers(0, 1, 2)), ids(0), 1.5).data.tracks[0].keys.map(({ value }) => value)).toEqual([
      10, 0, 20,
    ]);
  });

  test('leaves other tracks the same objects', () => {
    const data = setKey(clipOf(...numbers(0, 1)), place, 0, [0, 0, 0]);
    const moved = moveKeys(data, ids(0), 0.5).data;
    expect(moved.tracks[1]).toBe(data.tracks[1]);
    expect(moved.tracks[0]).not.toBe(data.tracks[0]);
  });
});

test('scaleKeys stretches about a time, snaps, and keys that fall together become one', () => {
  const data = clipOf(...numbers(1, 2, 3));
  expect(timesOf(scaleKeys(data, ids(1, 2, 3), 1, 2).data)).toEqual([1, 3, 5]);
  expect(timesOf(scaleKeys(data, ids(1, 2, 3), 3, 0.5).data)).toEqual([2, 2.5, 3]);
  const { data: small, selected } = scaleKeys(data, ids(1, 2, 3), 1, 0.1, Math.round);
  expect(small.tracks[0].keys).toEqual([{ time: 1, value: 30 }]);
  expect(selected).toEqual(ids(1));
});

test('deleteKeys takes tracks along that have none then; removeTracks takes them with their keys', () => {
  const data = setKey(clipOf(...numbers(0, 1)), place, 0, [0, 0, 0]);
  expect(timesOf(deleteKeys(data, ids(0)))).toEqual([1]);
  expect(deleteKeys(data, ids(0, 1)).tracks).toEqual([data.tracks[1]]);
  expect(removeTracks(data, new Set([trackId(place)])).tracks).toEqual([data.tracks[0]]);
  expect(allKeys(data).size).toBe(3);
});

test('retargetTrack keeps the keys, and does nothing where such a track is there', () => {
  const data = setKey(clipOf(...numbers(0, 1)), place, 0, [0, 0, 0]);
  const other = { ...glow, path: 'Torch' };
  expect(retargetTrack(data, glow, other).tracks[0]).toEqual({ ...other, keys: data.tracks[0].keys });
  expect(retargetTrack(data, glow, place)).toBe(data);
});

test('easeKeys sets easing and handles; linear leaves neither, and what steps anyway stays', () => {
  const data = clipOf(...numbers(0, 1));
  const eased = easeKeys(data, ids(0), 'bezier', [0.42, 0, 0.58, 1]);
  expect(eased.tracks[0].keys[0]).toEqual({ time: 0, value: 0, easing: 'bezier', control: [0.42, 0, 0.58, 1] });
  expect(easeKeys(eased, ids(0), 'step').tracks[0].keys[0]).toEqual({ time: 0, value: 0, easing: 'step' });
  expect(easeKeys(eased, ids(0), 'linear').tracks[0].keys).toEqual(data.tracks[0].keys);
  const flags = clipOf({ time: 0, value: true });
  expect(easeKeys(flags, ids(0), 'bezier').tracks[0].keys).toEqual(flags.tracks[0].keys);
});

test('setValuesOfKeys, rangeOfKeys and keptSelection know what is selected', () => {
  const data = clipOf(...numbers(0, 1, 2));
  const raised = setValuesOfKeys(data, ids(1, 2), (value) => (value as number) + 1);
  expect(raised.tracks[0].keys.map(({ value }) => value)).toEqual([0, 11, 21]);
  expect(rangeOfKeys(data, ids(1, 2))).toEqual({ first: 1, last: 2 });
  expect(rangeOfKeys(data, new Set())).toBeNull();
  expect(keptSelection(data, ids(1, 7))).toEqual(ids(1));
});

describe('copyKeys and pasteKeys', () => {
  const data = setKey(clipOf(...numbers(1, 2, 3)), place, 2, [1, 1, 1]);

  test('put keys of several tracks at a time, over what is there', () => {
    const selected = new Set([...ids(2, 3), keyId(trackId(place), 2)]);
    const copied = readCopiedKeys(JSON.stringify(copyKeys(data, selected)))!;
    const pasted = pasteKeys(data, copied, 0.5);
    expect(pasted.data.tracks[0].keys).toEqual([
      { time: 0.5, value: 20 },
      { time: 1, value: 10 },
      { time: 1.5, value: 30 },
      { time: 2, value: 20 },
      { time: 3, value: 30 },
    ]);
    expect(pasted.data.tracks[1].keys.map(({ time }) => time)).toEqual([0.5, 2]);
    expect(pasted.selected.size).toBe(3);
    expect(pasteKeys(data, copied, 2).data.tracks[0].keys).toHaveLength(3);
  });

  test('make tracks that are not there, and put those of one track where they shall go', () => {
    const copied = copyKeys(data, ids(1, 2))!;
    const other = { ...glow, path: 'Torch' };
    expect(pasteKeys(data, copied, 0, other).data.tracks[2]).toEqual({
      ...other,
      keys: [
        { time: 0, value: 10 },
        { time: 1, value: 20 },
      ],
    });
    expect(pasteKeys({ tracks: [], events: [] }, copied, 0).data.tracks).toHaveLength(1);
  });

  test('take nothing else for keys', () => {
    expect(copyKeys(data, new Set())).toBeNull();
    for (const text of [
      '',
      '{}',
      '"farol-keys"',
      '{"kind":"farol-keys"}',
      '{"kind":"other","x":"farol-keys"}',
      '{"kind":"farol-keys","tracks":[null]}',
      '{"kind":"farol-keys","tracks":[{"keys":[{"time":"x"}]}]}',
    ])
      expect(readCopiedKeys(text)).toBeNull();
  });
});

test('events are kept in order, and followed as they move', () => {
  let edit = addEvent({ tracks: [], events: [] }, { time: 1, method: 'land' });
  edit = addEvent(edit.data, { time: 0.5, method: 'jump' });
  expect(edit).toMatchObject({ places: [0], data: { events: [{ method: 'jump' }, { method: 'land' }] } });
  edit = moveEvents(edit.data, [0], 2);
  expect(edit).toMatchObject({ places: [1], data: { events: [{ method: 'land' }, { time: 2.5, method: 'jump' }] } });
  edit = moveEvents(edit.data, [0, 1], -9);
  expect(edit.data.events.map(({ time }) => time)).toEqual([0, 1.5]);
  edit = changeEvent(edit.data, 1, { method: 'leap', value: 3 });
  expect(edit.data.events[1]).toEqual({ time: 1.5, method: 'leap', value: 3 });
  expect(changeEvent(edit.data, 1, { value: undefined }).data.events[1]).toEqual({ time: 1.5, method: 'leap' });
  expect(removeEvents(edit.data, [0]).events).toHaveLength(1);
});

test('writeClip writes what the engine writes, and an empty clip as nothing', () => {
  const data = addEvent(setKey(clipOf(...numbers(1 / 3, 2, 3)), place, 2, [0.1 + 0.2, 1, 1]), {
    time: 1,
    method: 'onStep',
    value: 'left',
  }).data;
  expect(writeClip(data)).toBe(clipText(data));
  expect(writeClip(parseClip(writeClip(data)))).toBe(writeClip(data));
  expect(writeClip({ tracks: [], events: [] })).toBe('');
  expect(clipDataOf({ getAuthored: () => writeClip(data), clip: data } as never)).toBe(data);
});
