import { describe, expect, it } from 'vitest';
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
  dragons: ['low', 'high'],
  antialiasing: ['none', 'smaa', 'edges', 'taa'],
  defaults: {
    ...{
      scene: 'temple',
      technique: 'deferred',
      view: 'final',
      parameters: {},
      dragon: 'low',
      aa: 'none',
      ao: false,
      oit: false,
      decals: false,
    },
    ...{ time: null, width: null, height: null, dpr: null, gui: true },
  },
};

describe('readState', () => {
  it('gives the defaults for an empty query', () => {
    expect(readState('', known)).toEqual({ state: known.defaults, problems: [] });
  });

  it('reads every parameter', () => {
    const query =
      '?scene=planes&technique=auto&view=albedo&n=7&mesh=dragon&dragon=high&aa=taa&ao=1&oit=1&decals=1&time=2.5&width=160&height=90&dpr=1&gui=0';
    const { state, problems } = readState(query, known);
    expect(problems).toEqual([]);
    expect(state).toEqual({
      ...{ scene: 'planes', technique: 'auto', view: 'albedo', parameters: { n: 7, mesh: 'dragon' }, dragon: 'high' },
      ...{ aa: 'taa', ao: true, oit: true, decals: true, time: 2.5, width: 160, height: 90, dpr: 1, gui: false },
    });
  });

  it.each([
    ['scene=palace', /scene=palace .* temple, planes/],
    ['technique=Deferred', /technique=Deferred .* auto, forward, deferred/],
    ['view=', /view= .* final, albedo/],
    ['time=-1', /time=-1 .* of 0 or more/],
    ['time=NaN', /time=NaN .* number/],
    ['width=12.5', /width=12.5 .* whole number from 1 to 8192/],
    ['dpr=', /dpr= .* number from 0.1 to 8/],
    ['dragon=huge', /dragon=huge .* low, high/],
    ['aa=msaa', /aa=msaa .* none, smaa, edges, taa/],
    ['ao=yes', /ao=yes .* 1 or 0/],
    ['gui=no', /gui=no .* 1 or 0/],
    ['lights=many', /lights=many .* whole number from 0 to 4096/],
    ['lihgts=3', /lihgts .* unknown .* lights/],
    ['scene=planes&mesh=cat', /mesh=cat .* box, dragon/],
    ['scene=planes&centre=1,2', /centre=1,2 .* three numbers/],
  ])('names what is wrong with %s, and takes the default', (query, message) => {
    const { state, problems } = readState(query, known);
    expect(problems).toHaveLength(1);
    expect(problems[0]).toMatch(message);
    expect({ ...state, scene: 'temple' }).toEqual(known.defaults);
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
    ...{ scene: 'planes', technique: 'forward', view: 'albedo', dragon: 'high', aa: 'smaa', ao: true, oit: true },
    ...{ decals: true, parameters: { n: 12, mesh: 'dragon', centre: [0, 1.5, -2] } },
    ...{ time: 0, width: 320, height: 180, dpr: 1.5, gui: false },
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
