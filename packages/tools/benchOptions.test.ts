import { describe, expect, it } from 'vitest';
import { benchHelp, optionTypes, parseBenchOptions } from './benchOptions.mjs';

describe('parseBenchOptions without a preset', () => {
  it('measures everything that there is when nothing is said', () => {
    expect(parseBenchOptions([])).toEqual({
      mode: 'matrix',
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
    if (options.mode !== 'matrix') throw new Error('A preset is measured.');
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
    [['--rivals'], /--rivals belongs to the Lab: give a --preset too/],
    [['--turn', '100'], /--turn belongs to the Lab/],
  ])('refuses %j and says why', (args, message) => {
    expect(() => parseBenchOptions(args)).toThrow(message);
  });
});

describe('parseBenchOptions with a preset', () => {
  it('leaves to the preset what is not said', () => {
    expect(parseBenchOptions(['--preset', 'quick'])).toEqual({
      ...{ mode: 'lab', fragment: 'preset=quick', techniques: null, lights: null, rivals: false, resume: false },
      ...{ withoutPictures: false, name: null, reference: null, timeout: 300, minutes: 0, gpu: false },
      ...{ buildOnly: false, dist: null, against: null, out: 'bench-results', help: false },
    });
  });

  it('says the rest as the Lab’s address does', () => {
    const size = ['--size', '1920x1080', '--rounds', '5', '--turn', '250'];
    expect(parseBenchOptions(['--preset', 'lights', '--techniques', 'stock,auto', ...size])).toMatchObject({
      fragment: 'preset=lights&techniques=stock%2Cauto&size=1920x1080&rounds=5&turn=250',
    });
  });

  it.each(['#preset=custom&series=sponza:lights:10,20', 'http://localhost/#preset=custom&series=sponza:lights:10,20'])(
    'takes the link %s, and lets an option stand over it',
    (link) => {
      const options = parseBenchOptions(['--link', link, '--rounds', '1', '--lights', '5']);
      expect(options).toMatchObject({ mode: 'lab', lights: [5] });
      expect(new URLSearchParams(options.mode === 'lab' ? options.fragment : '').toString()).toBe(
        new URLSearchParams('preset=custom&series=sponza:lights:10,20&rounds=1').toString(),
      );
    },
  );

  it('makes a reference of the thesis, without pictures, in parts', () => {
    expect(parseBenchOptions(['--reference', 'h200', '--minutes', '9', '--gpu'])).toMatchObject({
      ...{ mode: 'lab', fragment: 'preset=thesis', resume: true, withoutPictures: true, minutes: 9, gpu: true },
      ...{ reference: 'h200', out: '.cache/reference/h200' },
    });
  });

  it.each([
    [['--scenes', 'sponza'], /--scenes belongs to the viewer's matrix: .*--link/],
    [['--frames', '3'], /--frames belongs .*--turn/],
    [['--budget', '3'], /--budget belongs .*--turn/],
    [['--only-counts'], /--only-counts belongs .*has the counts/],
    [['--link', '#preset=lights'], /--preset and --link/],
    [['--turn', '1'], /--turn 1: a number of 10 or more/],
    [['--size', '1280'], /--size 1280/],
    [['--reference', '../x'], /--reference \.\.\/x: small letters/],
    [['--lights', 'few'], /--lights few/],
  ])('refuses %j and says why', (args, message) => {
    expect(() => parseBenchOptions(['--preset', 'lights', ...args])).toThrow(message);
  });
});

it('the help names every option', () => {
  for (const name of Object.keys(optionTypes)) expect(benchHelp).toContain(`\n  --${name} `);
});
