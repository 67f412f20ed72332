import type { WebGLRenderer } from 'three';
import { expect, it, vi } from 'vitest';
import { NO_EFFECTS } from '../frame/ActiveEffects';
import type { Frame } from '../frame/Frame';
import { Lazy } from '../frame/Lazy';
import type { Pass } from '../frame/Pass';
import type { LightTable } from '../lighting/LightTable';
import { MicroShaderRegistry } from '../microshaders';
import type { TechniqueName } from '../techniques';
import { warmUpCode } from './lazyCode';
import { type DrawnScene, TechniquePicker } from './TechniquePicker';
import { TechniqueSet } from './TechniqueSet';

// the parts of a WebGLRenderer that a picker reads
const device = (floatTargets: boolean) => {
  class Context {
    isContextLost() {
      return false;
    }
  }
  vi.stubGlobal('WebGL2RenderingContext', Context);
  const context = new Context();
  const found = { isWebGLRenderer: true, floatTargets, getContext: () => context };
  return Object.assign(found, { extensions: { has: () => found.floatTargets } });
};

const newScene = (): DrawnScene => ({ chooser: null, drawn: null, overdraw: null });

const passThat = (writes: Pass['writes']): Pass[] => [
  { name: 'pass', reads: [], writes, bytes: 0, render() {}, dispose() {} },
];

/** Draws frames of scenes by a picker, whose late code is not loaded until `load` is called. */
function makePicker() {
  const set = new TechniqueSet(new MicroShaderRegistry());
  const lates: Lazy<object>[] = [];
  for (const [name, technique] of Object.entries(set.known)) {
    const isThere = name === 'deferred' || name === 'forward-single-pass';
    const lazy = isThere ? undefined : new Lazy(name, () => Promise.resolve({}), 'others draw');
    if (lazy) lates.push(lazy);
    const writes: Pass['writes'] = name.endsWith('deferred') ? ['gbuffer'] : ['target'];
    set.known[name] = { ...technique, lightOrder: 'by-volume', passes: () => passThat(writes), ...(lazy && { lazy }) };
  }
  const webgl = device(true);
  const picker = new TechniquePicker(webgl as unknown as WebGLRenderer, set);
  const draw = (
    scene: DrawnScene,
    lights: number,
    { coverage = 0, surfaces = false, skewed = false } = {},
  ): TechniqueName => {
    const frame = {
      session: null,
      hasPlainProjection: !skewed,
      fields: null,
      queue: { opaque: Array.from({ length: 20 }), hasLitTransparents: false },
    };
    const table = { bounded: lights, coverage, directional: 0, unbounded: 0 };
    picker.pick(scene, frame as unknown as Frame, table as LightTable, { ...NO_EFFECTS, needsSurfaces: surfaces });
    return picker.active;
  };
  return { picker, set, webgl, draw, load: () => Promise.all(lates.map((lazy) => lazy.load())) };
}

it('begins by one of two techniques until the rules of auto are there', async () => {
  const { draw, picker } = makePicker();
  const scene = newScene();
  const late = vi.spyOn(warmUpCode, 'use').mockReturnValue(null);
  expect([draw(scene, 3), draw(newScene(), 60), draw(newScene(), 3, { surfaces: true })]).toEqual([
    'forward-single-pass',
    'deferred',
    'deferred',
  ]);
  expect(picker.reason).toBe('the code of "auto" is being fetched');
  late.mockRestore();
  await warmUpCode.load();
  draw(scene, 0);
  expect([picker.active, picker.reason]).toEqual(['forward-single-pass', 'few lights: lists cost more than they save']);
});

it('goes on by the technique that has drawn a scene while its lights load, until the code of the one that settles is there', async () => {
  const { draw, load, picker } = makePicker();
  const scene = newScene();
  const drawn = [0, 3, 12, 17, 60, 128].map((lights) => draw(scene, lights, { coverage: lights / 2 }));
  expect(new Set(drawn)).toEqual(new Set(['forward-single-pass']));
  expect(picker.reason).toBe('the code of "clustered-deferred" is being fetched');
  await load();
  expect(draw(scene, 60, { coverage: 30 })).toBe('clustered-deferred');
});

it('goes on by deferred shading too, when lights go', async () => {
  const { draw, load } = makePicker();
  const scene = newScene();
  expect([20, 10, 3].map((lights) => draw(scene, lights))).toEqual(['deferred', 'deferred', 'deferred']);
  await load();
  expect(draw(scene, 3)).toBe('clustered-forward');
});

it('begins by what suits the lights of each scene, and of each alone', () => {
  const { draw } = makePicker();
  const [few, many] = [newScene(), newScene()];
  for (let frame = 0; frame < 2; frame++)
    expect([draw(few, 3), draw(many, 60)]).toEqual(['forward-single-pass', 'deferred']);
});

it('takes another while code is fetched only where the one that has drawn cannot draw the frame', () => {
  const { draw, webgl } = makePicker();
  const begun = () => {
    const scene = newScene();
    expect(draw(scene, 3)).toBe('forward-single-pass');
    return scene;
  };
  expect(draw(begun(), 129), 'more lights than one loop is to walk').toBe('deferred');
  expect(draw(begun(), 60, { surfaces: true }), 'an effect works on a G-buffer').toBe('deferred');
  const scene = newScene();
  expect(draw(scene, 60)).toBe('deferred');
  webgl.floatTargets = false;
  expect(draw(scene, 60), 'no float targets').toBe('forward-single-pass');
});

it('goes on by what has drawn when a technique is asked for, and by nothing that was removed', async () => {
  const { draw, load, picker, set } = makePicker();
  const scene = newScene();
  set.add('mine', set.known.deferred);
  picker.technique = 'mine' as TechniqueName;
  expect(draw(scene, 60)).toBe('mine');
  picker.technique = 'inferred';
  expect(draw(scene, 60)).toBe('mine');
  set.remove('mine');
  expect(draw(scene, 60)).toBe('deferred');
  await load();
  expect(draw(scene, 60)).toBe('inferred');
});
