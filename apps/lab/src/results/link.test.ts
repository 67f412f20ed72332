import { describe, expect, it } from 'vitest';
import type { Configuration } from '../plan/Configuration';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import { configurationOf, linkOf } from './link';

const own: Configuration = {
  preset: 'custom',
  series: [
    { scene: 'sponza', n: 1, axis: 'lights', values: [10, 100, 1000], lights: 0 },
    { scene: 'benchmarkLights', n: 15, axis: 'pixels', values: [230.4, 922], lights: 'objects' },
    { scene: 'benchmarkLights', n: 1, axis: 'objects', values: [4, 25], lights: 100 },
    { scene: 'temple', n: 1, axis: 'shadows', values: [0, 4], lights: 64 },
  ],
  ...{ width: 1920, height: 1080, competitors: ['deferred', 'stock', 'babylon'] },
  effort: { rounds: 5, turn: 250, changes: true, longestFrame: 4000, limit: 30_000 },
};

describe('linkOf and configurationOf', () => {
  it.each(Object.keys(presets))('say the preset %s by its name alone', (name) => {
    const { configuration } = presets[name];
    expect(linkOf(configuration)).toBe(`#preset=${name}`);
    expect(configurationOf(linkOf(configuration))).toEqual({ configuration, problems: [] });
  });

  it('go there and back with a configuration of one’s own, in an address that can be read', () => {
    const link = linkOf(own);
    expect(link).toBe(
      '#preset=custom&series=sponza:lights:10,100,1000&series=benchmarkLights:pixels:230.4,922:n=15:lights=objects' +
        '&series=benchmarkLights:objects:4,25:lights=100&series=temple:shadows:0,4:lights=64' +
        '&size=1920x1080&techniques=deferred,stock,babylon&rounds=5&turn=250&changes=yes&longest=4000&seconds=30',
    );
    expect(configurationOf(link)).toEqual({ configuration: own, problems: [] });
    // encoded as a browser returns it
    expect(configurationOf(new URL(`http://localhost/${link}`).hash)).toEqual({ configuration: own, problems: [] });
  });

  it('hold what differs from a preset, a limit taken off too', () => {
    const { configuration } = presets.quick;
    const changed = { ...configuration, height: 800, effort: { ...configuration.effort, limit: null, changes: false } };
    expect(linkOf(changed)).toBe('#preset=quick&size=1280x800&changes=no&seconds=0');
    expect(configurationOf(linkOf(changed))?.configuration).toEqual(changed);
  });

  it('have nothing to say where the address says nothing', () => {
    expect(configurationOf('')).toBeNull();
    expect(configurationOf('#charts')).toBeNull();
  });

  it.each<[string, RegExp, (configuration: Configuration) => unknown, unknown]>([
    ['preset=speed', /no preset speed: Quick stands in\. Known are quick, thesis/, ({ preset }) => preset, 'quick'],
    ['preset=__proto__', /no preset __proto__/, ({ preset }) => preset, 'quick'],
    ['preset=lights&size=big', /size=big .*1280x720/, ({ width }) => width, 1280],
    ['preset=lights&size=9000x600', /size=9000x600/, ({ height }) => height, 720],
    [
      'preset=lights&techniques=magic,stock',
      /techniques=magic: .*Known are auto/,
      (each) => each.competitors,
      ['stock'],
    ],
    [
      'preset=lights&techniques=',
      /techniques= names none/,
      (each) => each.competitors,
      presets.lights.configuration.competitors,
    ],
    ['preset=lights&rounds=2.5', /rounds=2\.5 is none: give a whole number of turns from 1/, (c) => c.effort.rounds, 3],
    ['preset=lights&turn=0', /turn=0 is none: give milliseconds a turn from 10/, (each) => each.effort.turn, 400],
    ['preset=lights&changes=maybe', /changes=maybe is none: give yes or no/, (each) => each.effort.changes, false],
    ['preset=lights&speed=1', /a setting speed, which the Lab does not know/, ({ preset }) => preset, 'lights'],
    ['preset=custom', /names no series/, ({ series }) => series, presets.lights.configuration.series],
    [
      'series=moon:lights:1',
      /series=moon:lights:1 is left out: Unknown scene moon: choose one of/,
      (c) => c.preset,
      'custom',
    ],
    ['preset=lights&series=sponza:mood:1', /sponza:mood:1 is left out: .*axes are/, (each) => each.series.length, 2],
    ['preset=lights&series=sponza:lights:few', /its values are no numbers/, (each) => each.series.length, 2],
    ['preset=lights&series=sponza:lights', /its values are no numbers/, (each) => each.series.length, 2],
    ['preset=lights&series=sponza:lights:1:n=0', /n=0 is unknown/, (each) => each.series.length, 2],
    ['preset=lights&series=sponza:lights:-5', /-5 is not a value/, (each) => each.series.length, 2],
  ])('name what is wrong in #%s, and keep the rest', (fragment, problem, pick, value) => {
    const linked = configurationOf(`#${fragment}`)!;
    expect(linked.problems.join(' ')).toMatch(problem);
    expect(pick(linked.configuration)).toEqual(value);
    expect(() => planOf(linked.configuration)).not.toThrow();
  });

  it.each(['__proto__', 'constructor', 'toString'])('name %s as a scene that there is not', (name) => {
    const { problems } = configurationOf(`#series=${name}:lights:1`)!;
    expect(problems[0]).toMatch(`series=${name}:lights:1 is left out: Unknown scene ${name}: choose one of`);
  });

  it('say little of an address of a million letters, and take no more series and values than a run may have', () => {
    const long = 'x'.repeat(1_000_000);
    const fragments = [
      `preset=${long}`,
      `preset=lights&${long}=1`,
      `preset=lights&size=${long}`,
      `preset=lights&techniques=${long}`,
      `preset=lights&techniques=${'a,'.repeat(500_000)}`,
      `preset=lights&turn=${long}`,
      `series=${long}`,
      `series=sponza:lights:1:${long}`,
      `series=sponza:lights:1:kind=${long}`,
      `series=moon:lights:${'1,'.repeat(500_000)}1`,
      `series=sponza:lights:${'1,'.repeat(500_000)}1`,
      `preset=lights${'&series=moon:lights:1'.repeat(50_000)}`,
      `preset=lights&${Array.from({ length: 50_000 }, (_, i) => `name${i}=1`).join('&')}`,
    ];
    for (const fragment of fragments) {
      expect(configurationOf(fragment)!.problems.join('\n').length, fragment.slice(0, 40)).toBeLessThan(2000);
    }
    const many = Array.from({ length: 51 }, () => 'series=sponza:lights:1').join('&');
    const { configuration, problems } = configurationOf(many)!;
    expect(configuration.series).toHaveLength(50);
    expect(problems).toEqual(['The address has 51 series, and 50 is the limit: the others are left out.']);
  });
});
