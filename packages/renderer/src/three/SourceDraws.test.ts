import { Mesh, MeshStandardMaterial, PerspectiveCamera, Scene, type Material, type WebGLRenderer } from 'three';
import { expect, it, vi } from 'vitest';
import type { DirectDraw } from './directDraw';
import { SourceDraws } from './SourceDraws';

/** A renderer whose draws note the record that a material has, and ask for a program where `needsProgram` is set. */
function fakeRenderer() {
  const records = new Map<unknown, Record<string, unknown>>();
  const drawn: unknown[] = [];
  const state = { needsProgram: false };
  const getTarget = vi.fn<() => null>(() => null);
  const get = (object: unknown) => records.get(object) ?? records.set(object, {}).get(object)!;
  const webgl = { properties: { get }, getRenderTarget: getTarget } as unknown as WebGLRenderer;
  const direct: DirectDraw = (_c, _s, _g, material) => {
    drawn.push(webgl.properties.get(material));
    if (state.needsProgram) webgl.getRenderTarget();
  };
  const [source, mesh, scene, camera] = [new MeshStandardMaterial(), new Mesh(), new Scene(), new PerspectiveCamera()];
  const twin = Object.create(source) as Material;
  records.set(twin, { currentProgram: {}, __version: source.version });
  const draws = new SourceDraws(webgl, direct);
  const draw = (properties?: object): boolean =>
    draws.draw(camera, scene, mesh.geometry, source, twin, properties, mesh, null);
  return { webgl, records, drawn, state, get, getTarget, source, twin, scene, draws, draw };
}

it('draws the source with the record of its twin, and leaves three as it was', () => {
  const { webgl, records, drawn, get, getTarget, twin, draws, draw } = fakeRenderer();
  expect(draw()).toBe(true);
  expect(drawn).toEqual([records.get(twin)]);
  webgl.getRenderTarget();
  expect(getTarget, 'the host asks between draws').toHaveBeenCalledOnce();
  draws.end();
  expect(webgl.properties.get).toBe(get);
  expect(webgl.getRenderTarget).toBe(getTarget);
});

it('leaves the draw to the twin where three needs another program, and has three look for it there', () => {
  const { records, state, twin, draw } = fakeRenderer();
  state.needsProgram = true;
  expect(draw()).toBe(false);
  expect(records.get(twin)!.__version).toBe(-1);
});

it.each<[string, (fake: ReturnType<typeof fakeRenderer>) => object | void]>([
  ['the twin was not drawn yet', ({ records, twin }) => void delete records.get(twin)!.currentProgram],
  [
    'the twin has changed otherwise than its source',
    ({ twin }) => void Object.defineProperty(twin, 'version', { value: 7 }),
  ],
  ['the source has a callback', ({ source }) => void (source.onBeforeRender = () => undefined)],
  ['the twin blends otherwise', () => ({ blending: 2 })],
  ['the twin has no fog in a scene that has', ({ scene }) => ((scene.fog = {} as never), { fog: false })],
])('leaves the draw to the twin where %s', (_, change) => {
  const fake = fakeRenderer();
  expect(fake.draw(change(fake) ?? undefined)).toBe(false);
  expect(fake.drawn).toEqual([]);
});
