import { expect, test } from 'vitest';
import { AtlasMap, type MapState } from './AtlasMap';

const ways: Record<MapState, (map: AtlasMap) => unknown> = {
  none: () => undefined,
  empty: (map) => map.place(),
  lost: (map) => (ways.whole(map), map.lose()),
  partial: (map) => draw(map, true),
  whole: (map) => draw(map, false),
  'stale-partial': (map) => (ways.partial(map), map.change()),
  'stale-whole': (map) => (ways.whole(map), map.change()),
};

function draw(map: AtlasMap, isPartial: boolean): void {
  map.place();
  map.plan(isPartial);
  map.draw();
}

const states = Object.keys(ways) as MapState[];

function mapIn(state: MapState): AtlasMap {
  const map = new AtlasMap();
  ways[state](map);
  expect(map.state).toBe(state);
  return map;
}

test.each<[string, (map: AtlasMap) => void, Record<MapState, MapState | Error>]>([
  [
    'place',
    (map) => map.place(),
    {
      none: 'empty',
      empty: 'empty',
      lost: 'empty',
      partial: 'empty',
      whole: 'empty',
      'stale-partial': 'empty',
      'stale-whole': 'empty',
    },
  ],
  [
    'release',
    (map) => map.release(),
    {
      none: 'none',
      empty: 'none',
      lost: 'none',
      partial: 'none',
      whole: 'none',
      'stale-partial': 'none',
      'stale-whole': 'none',
    },
  ],
  [
    'lose',
    (map) => map.lose(),
    {
      none: 'none',
      empty: 'empty',
      lost: 'lost',
      partial: 'lost',
      whole: 'lost',
      'stale-partial': 'empty',
      'stale-whole': 'empty',
    },
  ],
  [
    'change',
    (map) => map.change(),
    {
      none: 'none',
      empty: 'empty',
      lost: 'empty',
      partial: 'stale-partial',
      whole: 'stale-whole',
      'stale-partial': 'stale-partial',
      'stale-whole': 'stale-whole',
    },
  ],
  [
    'plan and draw a part',
    (map) => (map.plan(true), map.draw()),
    {
      none: new Error('without a region'),
      empty: 'partial',
      lost: 'partial',
      partial: 'partial',
      whole: 'partial',
      'stale-partial': 'partial',
      'stale-whole': 'partial',
    },
  ],
  [
    'plan and draw all',
    (map) => (map.plan(false), map.draw()),
    {
      none: new Error('without a region'),
      empty: 'whole',
      lost: 'whole',
      partial: 'whole',
      whole: 'whole',
      'stale-partial': 'whole',
      'stale-whole': 'whole',
    },
  ],
])('%s', (_, act, expected) => {
  for (const state of states) {
    const map = mapIn(state);
    const after = expected[state];
    if (after instanceof Error) {
      expect(() => act(map)).toThrow(after.message);
      expect(map.state).toBe(state);
    } else {
      act(map);
      expect(map.state, `from ${state}`).toBe(after);
    }
  }
});

test('what a state means', () => {
  const facts = states.map((state) => {
    const { isThere, isCurrent, isStale, isPartial } = mapIn(state);
    return [state, isThere, isCurrent, isStale, isPartial];
  });
  expect(facts).toEqual([
    ['none', false, false, true, false],
    ['empty', false, false, true, false],
    ['lost', false, false, false, false],
    ['partial', true, true, false, true],
    ['whole', true, true, false, false],
    ['stale-partial', true, false, true, true],
    ['stale-whole', true, false, true, false],
  ]);
});

test('a plan alone draws nothing, and must be made for each draw', () => {
  const map = mapIn('stale-partial');
  map.plan(false);
  expect(map.state).toBe('stale-partial');
  map.plan(true);
  map.draw();
  expect(map.state).toBe('partial');
  expect(() => map.draw()).toThrow('before it was planned');
  map.plan(true);
  map.release();
  expect(() => map.draw(), 'its region is gone').toThrow('before it was planned');
  map.place();
  expect(() => map.draw(), 'of another region').toThrow('before it was planned');
});

test('bounds are of what is drawn: a change keeps them, a draw, a loss or another region do not', () => {
  for (const state of ['none', 'empty', 'lost'] as const) expect(() => mapIn(state).bound()).toThrow('no bounds');
  const ends: ((map: AtlasMap) => void)[] = [
    (map) => map.plan(false),
    (map) => map.lose(),
    (map) => map.place(),
    (map) => map.release(),
  ];
  for (const end of ends) {
    const map = mapIn('whole');
    map.bound();
    map.change();
    expect(map.hasBounds).toBe(true);
    end(map);
    expect(map.hasBounds).toBe(false);
  }
});

test('the frame of the last change, and whether there ever was a map', () => {
  const map = new AtlasMap();
  map.place();
  map.noteAge(3);
  expect([map.since, map.wasDrawn]).toEqual([3, false]);
  map.plan(false);
  map.draw();
  map.noteAge(4);
  expect([map.since, map.wasDrawn]).toEqual([3, true]);
  map.lose();
  map.noteAge(5);
  expect(map.since, 'a loss is no change').toBe(3);
  map.change();
  map.noteAge(6);
  map.release();
  expect([map.since, map.wasDrawn]).toEqual([6, true]);
});
