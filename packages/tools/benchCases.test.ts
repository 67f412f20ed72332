import { describe, expect, it } from 'vitest';
import { benchCases, caseKey, lightParameters } from './benchCases.mjs';

const known = {
  techniques: ['forward', 'deferred'],
  scenes: { sponza: ['lights', 'seed'], benchmarkLights: ['n', 'm'], still: ['seed'] },
};
const options = { scenes: null, techniques: null, lights: [10, 100], sizes: [{ width: 320, height: 180 }] };
const scene = (name: string, parameters: Record<string, string> = {}) => ({ name, parameters });

describe('benchCases', () => {
  it('is every scene with every number of lights by every technique; a scene of a fixed number once', () => {
    const keys = benchCases(options, [known]).map(caseKey);
    expect(keys).toEqual([
      ...['sponza 320×180 10 forward', 'sponza 320×180 10 deferred'],
      ...['sponza 320×180 100 forward', 'sponza 320×180 100 deferred'],
      ...['benchmarkLights 320×180 10 forward', 'benchmarkLights 320×180 10 deferred'],
      ...['benchmarkLights 320×180 100 forward', 'benchmarkLights 320×180 100 deferred'],
      ...['still 320×180  forward', 'still 320×180  deferred'],
    ]);
  });

  it('puts two builds side by side, and leaves out for one what it lacks', () => {
    const older = { techniques: ['forward'], scenes: known.scenes };
    const cases = benchCases({ ...options, scenes: [scene('sponza')], lights: [10] }, [known, older]);
    expect(cases.map(({ technique, build }) => [technique, build])).toEqual([
      ['forward', 0],
      ['forward', 1],
      ['deferred', 0],
    ]);
  });

  it('says all of it to the viewer: scene, lights, size, and that time stands', () => {
    const [first] = benchCases({ ...options, scenes: [scene('benchmarkLights', { n: '15' })] }, [known]);
    expect(Object.fromEntries(new URLSearchParams(first.query))).toEqual({
      ...{ scene: 'benchmarkLights', technique: 'forward', n: '15', m: '3', time: '0' },
      ...{ width: '320', height: '180', dpr: '1', gui: '0' },
    });
    expect(caseKey(first)).toBe('benchmarkLights:n=15 320×180 10 forward');
  });

  it('leaves a number of lights that was chosen for the scene alone', () => {
    const cases = benchCases({ ...options, scenes: [scene('sponza', { lights: '7' })] }, [known]);
    expect(cases).toHaveLength(2);
    expect(new URLSearchParams(cases[0].query).getAll('lights')).toEqual(['7']);
  });

  it('refuses what no build has, and names what there is', () => {
    expect(() => benchCases({ ...options, techniques: ['magic'] }, [known])).toThrow(/magic.*forward, deferred/);
    expect(() => benchCases({ ...options, scenes: [scene('palace')] }, [known])).toThrow(/palace.*sponza/);
  });
});

it('lights of a square grid are the nearest square', () => {
  expect(lightParameters(['n', 'm'], 225)).toEqual({ m: 15 });
  expect(lightParameters(['n', 'm'], 10)).toEqual({ m: 3 });
  expect(lightParameters(['lights', 'm'], 10)).toEqual({ lights: 10 });
  expect(lightParameters(['seed'], 10)).toEqual({});
});
