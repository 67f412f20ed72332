import { describe, expect, it } from 'vitest';
import type { LabRun } from './LabRun';
import { LONGEST_RUN, parseRun } from './parseRun';
import { testRun } from './testing/testRun';

/** The run's JSON with one value replaced. */
function changed(path: (string | number)[], value: unknown): string {
  const run = JSON.parse(JSON.stringify(testRun()));
  const last = path.at(-1)!;
  const owner = path.slice(0, -1).reduce((object, key) => object[key], run);
  if (value === undefined) delete owner[last];
  else owner[last] = value;
  return JSON.stringify(run);
}

describe('parseRun', () => {
  it('reads back what JSON.stringify wrote of a run, to the last field', () => {
    expect(parseRun(JSON.stringify(testRun()))).toEqual(testRun());
  });

  it('takes the cases of an older run for points of the scene’s own reach and materials as they are', () => {
    const older = JSON.parse(JSON.stringify(testRun()));
    for (const { cases } of older.plan.series)
      for (const each of cases) for (const field of ['lightKind', 'lightRange', 'shading']) delete each[field];
    expect(parseRun(JSON.stringify(older))).toEqual(testRun());
    const [lasers, far] = ['lightKind', 'lightRange'].map((field) => ['plan', 'series', 0, 'cases', 0, field]);
    expect(() => parseRun(changed(lasers, 'lasers'))).toThrow(/lightKind is "lasers": give "points" or "spots" or /);
    expect(() => parseRun(changed(far, 0))).toThrow(/lightRange is 0: give a number from 0.1 to 100 \(m\)/);
  });

  it('reads a row that has no figure but a problem', () => {
    const row = {
      ...{ competitor: 'forward', series: 'planes-lights', index: 0, frame: null, cpu: null, gpu: null, firstMs: null },
      ...{ added: null, changed: null, counts: null, passes: null, likeness: null, dropped: 0, technique: null },
      ...{ reason: null, problem: 'Its first frame would take 12 s.', warnings: ['The tab was hidden.'] },
    };
    expect(parseRun(changed(['rows'], [row])).rows).toEqual([row]);
  });

  it.each<[(string | number)[], unknown, RegExp]>([
    [['rows', 3, 'frame', 'median'], 'fast', /^rows\[3\]\.frame\.median is "fast": give a number from 0 .*\(ms\)\.$/],
    [['rows', 3, 'frame', 'median'], -1, /rows\[3\]\.frame\.median is -1/],
    [['rows', 0, 'warnings'], 'slow', /rows\[0\]\.warnings is "slow": give a list/],
    [
      ['rows', 0, 'warnings'],
      ['w'.repeat(2001)],
      /rows\[0\]\.warnings\[0\] is "w+…: give a text of at most 2000 characters/,
    ],
    [['rows', 0, 'competitor'], 'stock', /rows\[0\]\.competitor is "stock": give one that plan\.competitors lists/],
    [['rows', 0, 'series'], 'temple', /rows\[0\]\.series is "temple": give the name of a series/],
    [['rows', 2, 'index'], 2, /rows\[2\]\.index is 2: series "planes-lights" has 2 cases/],
    [['rows', 2, 'index'], 0, /rows\[2\] is forward in case 0 of planes-lights once more/],
    [
      ['rows', 1, 'likeness', 'thumbnail'],
      'https://example.com/spy.png',
      /rows\[1\]\.likeness\.thumbnail is .*data URL/,
    ],
    [['rows', 1, 'likeness', 'thumbnail'], 'data:image/svg+xml;base64,AAAA', /thumbnail/],
    [
      ['rows', 1, 'passes', 'passes'],
      Array.from({ length: 101 }, () => ({ name: 'x', ms: 1 })),
      /passes has 101 entries: give at most 100/,
    ],
    [['rows', 1, 'counts', 'draws'], undefined, /rows\[1\]\.counts\.draws is missing/],
    [['plan', 'series', 0, 'axis'], 'mood', /plan\.series\[0\]\.axis is "mood": give "lights" or "objects"/],
    [['plan', 'series', 0, 'values'], [4], /plan\.series\[0\]\.values has 1 entries: give one for each of the 2/],
    [['plan', 'series', 1, 'name'], 'planes-lights', /plan\.series\[1\]\.name is "planes-lights" once more/],
    [['plan', 'series', 0, 'cases', 0, 'width'], 1e5, /cases\[0\]\.width is 100000: give a whole number from 1/],
    [['plan', 'competitors'], [], /plan\.competitors has 0 entries/],
    [['plan', 'effort'], null, /plan\.effort is null: give an object/],
    [['surroundings', 'date'], 'yesterday', /surroundings\.date is "yesterday": give a date as in 2026/],
    [['surroundings', 'versions'], { toString: '1' }, /surroundings\.versions has an entry "toString"/],
    [['surroundings', 'command'], {}, /surroundings\.command is an object/],
    [['complete'], 'yes', /complete is "yes": give true or false/],
    [['format'], 'other', /not a run of the Lab/],
    [['version'], 2, /version 2 .* reads 1: open it in a newer Lab/],
    [['version'], '1', /version is "1": give 1/],
  ])('refuses %j with %j, and names field and mend', (path, value, message) => {
    expect(() => parseRun(changed(path, value))).toThrow(message);
  });

  it.each<[string, RegExp]>([
    ['', /not JSON/],
    ['{"format":', /not JSON/],
    ['null', /not a run of the Lab/],
    ['[]', /not a run of the Lab/],
    [JSON.stringify(testRun()).replace('"duration":9000', '"duration":1e999'), /duration is Infinity/],
    ['['.repeat(200_000), /not JSON/],
    [' '.repeat(LONGEST_RUN + 1), /The file has 32 MB: a run has at most 32 MB/],
  ])('refuses a file of something else: %#', (source, message) => {
    expect(() => parseRun(source)).toThrow(message);
  });

  it('changes no prototype, whatever the names are', () => {
    const poison = '"__proto__":{"polluted":true}';
    const inVersions = JSON.stringify(testRun()).replace('"versions":{', `"versions":{${poison},`);
    expect(() => parseRun(inVersions)).toThrow(/versions has an entry "__proto__"/);
    // an unknown field is dropped
    const atTop = parseRun(JSON.stringify(testRun()).replace('{', `{${poison},`)) as LabRun & { polluted?: boolean };
    expect(atTop.polluted).toBeUndefined();
    expect(Object.getPrototypeOf(atTop)).toBe(Object.prototype);
    // a missing field is not read from a prototype
    expect(() => parseRun(changed(['plan'], undefined))).toThrow(/plan is missing/);
    expect({}).not.toHaveProperty('polluted');
  });

  it('leaves out fields that it does not know', () => {
    expect(parseRun(changed(['rows', 0, 'mood'], 'good'))).toEqual(testRun());
  });
});
