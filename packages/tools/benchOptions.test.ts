import { describe, expect, it } from 'vitest';
import { benchHelp, optionTypes, parseBenchOptions } from './benchOptions.mjs';

describe('parseBenchOptions', () => {
  it('leaves to the preset what is not said', () => {
    expect(parseBenchOptions([])).toEqual({
      ...{ fragment: 'preset=regression', regret: false, lights: null, rivals: false, resume: false, write: false },
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
      const options = parseBenchOptions(['--link', link, '--rounds', '1', '--lights', '5, 5,20']);
      expect(options.lights).toEqual([5, 20]);
      expect(new URLSearchParams(options.fragment).toString()).toBe(
        new URLSearchParams('preset=custom&series=sponza:lights:10,20&rounds=1').toString(),
      );
    },
  );

  it('makes a reference of the thesis, without pictures, in parts', () => {
    expect(parseBenchOptions(['--reference', 'h200', '--minutes', '9', '--gpu'])).toMatchObject({
      ...{ fragment: 'preset=thesis', resume: true, withoutPictures: true, minutes: 9, gpu: true },
      ...{ reference: 'h200', out: '.cache/reference/h200' },
    });
  });

  it.each([
    [['--link', '#preset=lights'], /--preset, --link and --regret/],
    [['--regret'], /--preset, --link and --regret/],
    [['--turn', '1'], /--turn 1: a number of 10 or more/],
    [['--rounds', '0'], /--rounds 0.*1 or more/],
    [['--rounds', '1.5'], /--rounds 1.5/],
    [['--size', '1280'], /--size 1280.*1280x720/],
    [['--size', '0x720'], /--size 0x720/],
    [['--reference', '../x'], /--reference \.\.\/x: small letters/],
    [['--lights', '10,many'], /--lights many.*whole number/],
    [['--lights', '10,,20'], /--lights 10,,20/],
    [['--lights', '-1'], /--lights/],
    [['--timeout', ''], /--timeout/],
    [['--dist', 'x', '--build-only'], /one of the two/],
    [['--turns', '3'], /turns/],
  ])('refuses %j and says why', (args, message) => {
    expect(() => parseBenchOptions(['--preset', 'lights', ...args])).toThrow(message);
  });
});

it('the help names every option', () => {
  for (const name of Object.keys(optionTypes)) expect(benchHelp).toContain(`\n  --${name} `);
});
