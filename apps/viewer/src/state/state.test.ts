import { describe, expect, it } from 'vitest';
import { fitSize } from './fitSize';
import { readState } from './readState';
import type { KnownNames, ViewerState } from './ViewerState';
import { writeState } from './writeState';

const help = '';
const known: KnownNames = {
  scenes: {
    temple: {
      parameters: {
        lights: { kind: 'number', default: 50, min: 0, max: 4096, integer: true, help },
        seed: { kind: 'number', default: 1, integer: true, help },
        lit: { kind: 'boolean', default: true, help },
      },
    },
    planes: {
      parameters: {
        n: { kind: 'number', default: 5, min: 1, integer: true, help },
        mesh: { kind: 'choice', default: 'box', options: ['box', 'dragon'], help },
        lights: { kind: 'number', default: 9, min: 0, max: 16, integer: true, help },
        centre: { kind: 'vector3', default: [0, 0, 0], help },
      },
    },
  },
  techniques: ['auto', 'forward', 'deferred'],
  views: ['final', 'albedo'],
  qualities: ['auto', 'full', 'lite'],
  antialiasing: ['none', 'smaa', 'edges', 'taa'],
  budgets: ['auto', 'on', 'off'],
  effects: {
    ao: { kind: 'boolean', default: false, help },
    reach: { kind: 'number', default: 0.5, min: 0, max: 4, help },
    oit: { kind: 'boolean', default: false, help },
  },
  defaults: {
    ...{
      scene: 'temple',
      technique: 'deferred',
      view: 'final',
      quality: 'auto',
      parameters: {},
      aa: 'none',
      effects: {},
      decals: false,
      particles: 0,
      rectangles: 0,
    },
    ...{ time: null, width: null, height: null, dpr: null, budget: 'auto', gui: true },
  },
};

describe('readState', () => {
  it('gives the defaults for an empty query', () => {
    expect(readState('', known)).toEqual({ state: known.defaults, problems: [] });
  });

  it('reads every parameter', () => {
    const query =
      '?scene=planes&technique=auto&view=albedo&quality=lite&n=7&mesh=dragon&aa=taa&ao=1&reach=2&oit=1&decals=1&particles=20000&rectangles=1000&time=2.5&width=160&height=90&dpr=1&budget=on&gui=0';
    const { state, problems } = readState(query, known);
    expect(problems).toEqual([]);
    expect(state).toEqual({
      ...{ scene: 'planes', technique: 'auto', view: 'albedo', parameters: { n: 7, mesh: 'dragon' } },
      ...{
        quality: 'lite',
        aa: 'taa',
        effects: { ao: true, reach: 2, oit: true },
        decals: true,
        particles: 20_000,
        rectangles: 1000,
        time: 2.5,
        width: 160,
        height: 90,
        dpr: 1,
        budget: 'on',
        gui: false,
      },
    });
  });

  it.each([
    ['scene=palace', /scene=palace .* temple, planes/],
    ['technique=Deferred', /technique=Deferred .* auto, forward, deferred/],
    ['view=', /view= .* final, albedo/],
    ['time=-1', /time=-1 .* of 0 or more/],
    ['time=NaN', /time=NaN .* number/],
    ['width=12.5', /width=12.5 .* whole number from 1 to 8192/],
    ['particles=-1', /particles=-1 .* whole number from 0 to 200000/],
    ['rectangles=1.5', /rectangles=1.5 .* whole number from 0 to 20000/],
    ['dpr=', /dpr= .* number from 0.1 to 8/],
    ['aa=msaa', /aa=msaa .* none, smaa, edges, taa/],
    ['ao=yes', /ao=yes .* 1 or 0/],
    ['reach=5', /reach=5 .* from 0 to 4/],
    ['gui=no', /gui=no .* 1 or 0/],
    ['lights=many', /lights=many .* whole number from 0 to 4096/],
    ['scene=planes&mesh=cat', /mesh=cat .* box, dragon/],
    ['scene=planes&centre=1,2', /centre=1,2 .* three numbers/],
    ['scene=__proto__', /scene=__proto__ .* temple, planes/],
    ['technique=constructor', /technique=constructor .* auto, forward/],
    ['lights=1e999', /lights=1e999 .* from 0 to 4096/],
    ['lights=Infinity', /lights=Infinity .* from 0 to 4096/],
    ['lights=%E0%A4%A', /lights=.* in the address: a whole number/],
    ['seed=1e400', /seed=1e400 .* whole number/],
  ])('names what is wrong with %s, and takes the default', (query, message) => {
    const { state, problems } = readState(query, known);
    expect(problems).toHaveLength(1);
    expect(problems[0]).toMatch(message);
    expect({ ...state, scene: 'temple' }).toEqual(known.defaults);
  });

  it.each(['lihgts', '__proto__', 'constructor', 'hasOwnProperty', 'toString', '%E0%A4%A', ''])(
    'names %s as unknown, with what is known, and leaves it out',
    (name) => {
      const { state, problems } = readState(`${name}=1`, known);
      // what cannot be seen is shown by its code
      const read = new URLSearchParams(name).keys().next().value ?? '';
      const shown = name === '' ? 'A name of no letters' : read.replace('\ufffd', String.raw`\u{fffd}`);
      expect(problems).toEqual([
        `${shown} in the address is unknown and left out.`,
        expect.stringMatching(/Known are .*lights/),
      ]);
      expect(state).toEqual(known.defaults);
      expect(Object.getPrototypeOf(state.parameters)).toBe(Object.prototype);
      expect(Reflect.ownKeys(state.parameters)).toEqual([]);
    },
  );

  it('takes the first of a name that is there more than once, and says so', () => {
    const { state, problems } = readState('lights=3&view=albedo&lights=4&view=final&lights=x', known);
    expect(state).toMatchObject({ view: 'albedo', parameters: { lights: 3 } });
    expect(problems).toEqual([
      'lights is in the address 3 times: the first counts.',
      'view is in the address 2 times: the first counts.',
    ]);
  });

  it('tells little of an address of a million letters', () => {
    const long = 'x'.repeat(1_000_000);
    const many = Array.from({ length: 50_000 }, (_, i) => `name${i}=1`).join('&');
    for (const query of [`scene=${long}`, `${long}=1`, `lights=${long}`, many]) {
      expect(readState(query, known).problems.join('\n').length).toBeLessThan(1000);
    }
  });

  it("takes a parameter's range from the scene at hand", () => {
    expect(readState('lights=17&scene=planes', known).problems).toHaveLength(1);
    expect(readState('lights=17&scene=temple', known).state.parameters).toEqual({ lights: 17 });
  });

  it('keeps a parameter of another scene', () => {
    expect(readState('scene=temple&n=3', known)).toMatchObject({ problems: [], state: { parameters: { n: 3 } } });
  });
});

describe('writeState', () => {
  const state: ViewerState = {
    ...{ scene: 'planes', technique: 'forward', view: 'albedo', quality: 'full', aa: 'smaa' },
    effects: { ao: true, reach: 0.25, oit: true },
    ...{ decals: true, particles: 500, rectangles: 30, parameters: { n: 12, mesh: 'dragon', centre: [0, 1.5, -2] } },
    ...{ time: 0, width: 320, height: 180, dpr: 1.5, budget: 'off', gui: false },
  };

  it('is read back as it was', () => {
    expect(readState(writeState(state, known), known)).toEqual({ state, problems: [] });
    const lit: ViewerState = { ...known.defaults, parameters: { lit: false, seed: 3 } };
    expect(readState(writeState(lit, known), known).state).toEqual(lit);
  });

  it('leaves defaults out, and what the scene does not have', () => {
    const parameters = { lights: 50, n: 3 };
    expect(writeState({ ...known.defaults, parameters }, known)).toBe('?scene=temple&technique=deferred&view=final');
  });
});

describe('fitSize', () => {
  it('leaves a size that the device draws as it is', () => {
    expect(fitSize(1280, 720, 2, 8192)).toEqual({ dpr: 2, problem: '' });
    expect(fitSize(7680, 4320, 1, 8192)).toEqual({ dpr: 1, problem: '' });
  });

  it.each([
    [8192, 8192, 8, 8192],
    [8192, 8, 8, 8192],
    [4096, 4096, 1, 2048],
    [8192, 1, 0.5, 2048],
    [1, 8192, 0.5, 2048],
    [8, 8192, 8, 8192],
  ])('%i × %i at %f, at most %i a side, is drawn smaller, and that is said', (width, height, dpr, side) => {
    const fitted = fitSize(width, height, dpr, side);
    expect(fitted.dpr).toBeLessThan(dpr);
    expect(Math.max(width, height) * fitted.dpr).toBeLessThanOrEqual(side);
    expect(width * height * fitted.dpr ** 2).toBeLessThanOrEqual(7680 * 4320 * 1.001);
    // and not smaller than necessary
    const wider = fitted.dpr * 1.001;
    expect(Math.max(width, height) * wider > side || width * height * wider ** 2 > 7680 * 4320).toBe(true);
    expect(fitted.problem).toMatch(/would have [\d,]+ × [\d,]+ pixels\. It is drawn with/);
  });
});
