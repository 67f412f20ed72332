import { describe, expect, it } from 'vitest';
import { benchHelp, parseBenchOptions } from './benchOptions.mjs';

describe('parseBenchOptions', () => {
  it('measures everything that there is when nothing is said', () => {
    expect(parseBenchOptions([])).toEqual({
      ...{ scenes: null, techniques: null, lights: [10, 100, 1000], sizes: [{ width: 1280, height: 720 }] },
      ...{ rounds: 3, frames: 60, budget: 2500, timeout: 60, minutes: 0, gpu: false, onlyCounts: false },
      ...{ buildOnly: false, dist: null, against: null, out: 'bench-results', help: false },
    });
  });

  it('reads lists, sizes and the parameters of scenes', () => {
    const options = parseBenchOptions([
      ...['--scenes', 'sponza,benchmarkLightsObjects:n=15:mesh=dragon', '--lights', '5,5, 20'],
      ...['--size=640x360,1280x720', '--techniques', 'deferred', '--gpu', '--against', 'HEAD~2', '--rounds', '1'],
    ]);
    expect(options.scenes).toEqual([
      { name: 'sponza', parameters: {} },
      { name: 'benchmarkLightsObjects', parameters: { n: '15', mesh: 'dragon' } },
    ]);
    expect(options.lights).toEqual([5, 20]);
    expect(options.sizes.map(({ height }) => height)).toEqual([360, 720]);
    expect(options).toMatchObject({ techniques: ['deferred'], gpu: true, against: 'HEAD~2', rounds: 1 });
  });

  it.each([
    [['--lights', '10,many'], /--lights many.*whole number/],
    [['--lights', '10,,20'], /--lights 10,,20/],
    [['--lights', '-1'], /--lights/],
    [['--size', '1280'], /--size 1280.*1280x720/],
    [['--size', '0x720'], /--size 0x720/],
    [['--rounds', '0'], /--rounds 0.*1 or more/],
    [['--rounds', '1.5'], /--rounds 1.5/],
    [['--budget', ''], /--budget/],
    [['--scenes', 'sponza:lights'], /name=value/],
    [['--dist', 'x', '--build-only'], /one of the two/],
    [['--frmaes', '3'], /frmaes/],
  ])('refuses %j and says why', (args, message) => {
    expect(() => parseBenchOptions(args)).toThrow(message);
  });
});

it('the help names every option', () => {
  const names = Object.keys(parseBenchOptions([])).map((name) => (name === 'sizes' ? 'size' : name));
  for (const name of names)
    expect(benchHelp).toContain(`--${name.replaceAll(/[A-Z]/g, (c) => `-${c.toLowerCase()}`)} `);
});
