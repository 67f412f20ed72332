import { Mesh, MeshStandardMaterial, type Object3D, PerspectiveCamera, Scene, type WebGLRenderer } from 'three';
import { beforeEach, expect, it, test } from 'vitest';
import type { FarolEffect } from '../../frame/FarolEffect';
import { defaultOptions, type FarolOptions } from '../../renderer/FarolOptions';
import type { FarolRenderer } from '../../renderer/FarolRenderer';
import { CanvasFarol, type FarolSettings } from './CanvasFarol';

type Drawn = Required<FarolOptions>;

const camera = new PerspectiveCamera();
const [page, portal] = [litScene(), litScene()];

function litScene(): Scene {
  return new Scene().add(new Mesh(undefined, new MeshStandardMaterial()));
}

let canvas: CanvasFarol;
let webgl: WebGLRenderer;
let isPresenting: boolean;
/** The renderer of each scene, in order: three, or a technique of Farol's. */
let draws: string[];
let farol: Drawn & { isDisposed: boolean; render(): void; dispose(): void; addEventListener(): void };

beforeEach(() => {
  draws = [];
  isPresenting = false;
  webgl = {
    render: () => void draws.push('three'),
    compile: () => new Set(),
    compileAsync: async (scene: Object3D) => scene,
    xr: {
      get isPresenting() {
        return isPresenting;
      },
    },
  } as unknown as WebGLRenderer;
  farol = {
    ...defaultOptions,
    isDisposed: false,
    ...{ addEventListener: () => {}, render: () => void draws.push(farol.technique) },
    dispose: () => void (farol.isDisposed = true),
  };
  canvas = CanvasFarol.of(webgl);
  canvas.farol = farol as unknown as FarolRenderer;
});

function settings({ scene = null, ...options }: FarolOptions & { scene?: Scene | null } = {}): FarolSettings {
  return { options, scene, invalidate: () => {} };
}

const effect = (): FarolEffect & { freed: number } => {
  const made = { name: 'test', freed: 0, dispose: () => void made.freed++ };
  return made as unknown as FarolEffect & { freed: number };
};

const settled = (): Promise<void> => new Promise((resolve) => queueMicrotask(resolve));

it('has each setting of its component, and the default of each that it leaves out', () => {
  const owner = {};
  const effects = [effect()];
  const all: Drawn = {
    ...{
      technique: 'deferred',
      view: 'albedo',
      quality: 'lite',
      timing: true,
      lightLayers: true,
      antialias: false,
      effects,
    },
    ...{ shadowAtlasSize: 1024, shadowCascades: 3, areaLightThreshold: 0, inferredScale: 1, heatMapMaximum: 8 },
    budget: { frame: 8 },
    learning: true,
  };
  canvas.mount(owner, settings(all));
  expect(farol).toMatchObject(all);
  canvas.mount(owner, settings());
  expect(farol).toMatchObject(defaultOptions);
  expect(() => canvas.mount({}, settings({ techniques: 'deferred' } as FarolOptions))).toThrow(
    /unknown option "techniques".* Is "technique" meant\?$/,
  );
});

it.each([false, true])('a scene that has settings of its own is drawn by those, mounted last: %s', (isLast) => {
  const mounts = [
    () => canvas.mount({}, settings({ technique: 'forward' })),
    () => canvas.mount({}, settings({ technique: 'deferred', scene: portal })),
  ];
  for (const mount of isLast ? mounts : mounts.toReversed()) mount();
  for (const scene of [page, portal, page]) webgl.render(scene, camera);
  expect(draws).toEqual(['forward', 'deferred', 'forward']);
});

it('draws no scene but its own where nothing is mounted for all, also in a headset', () => {
  canvas.mount({}, settings({ technique: 'deferred', scene: portal }));
  for (const scene of [page, portal]) webgl.render(scene, camera);
  isPresenting = true;
  webgl.render(portal, camera);
  expect(draws).toEqual(['three', 'deferred', 'deferred']);
});

it('compiles by three for a target that is another scene', async () => {
  canvas.mount({}, settings({ scene: portal }));
  let compiled: object | null = null;
  Object.assign(farol, { compileAsync: async (scene: object) => void (compiled = scene) });
  await webgl.compileAsync(portal, camera, page);
  await webgl.compileAsync(page, camera);
  expect(compiled).toBeNull();
  await webgl.compileAsync(portal, camera);
  expect(compiled).toBe(portal);
});

test('with the last component the renderer has its own methods again, and Farol is freed', async () => {
  const { render, compile, compileAsync } = webgl;
  const [one, two] = [{}, {}];
  for (const owner of [one, two]) canvas.mount(owner, settings());
  expect(webgl.render).not.toBe(render);
  canvas.unmount(one);
  await settled();
  expect(farol.isDisposed).toBe(false);
  canvas.unmount(two);
  expect([webgl.render, webgl.compile, webgl.compileAsync]).toEqual([render, compile, compileAsync]);
  await settled();
  expect([farol.isDisposed, canvas.farol]).toEqual([true, null]);
});

test('a component that is taken out and put in at once keeps Farol and its effects, as under StrictMode', async () => {
  const [kept, gone, shared] = [effect(), effect(), effect()];
  const owner = {};
  const other = settings({ scene: portal, effects: [shared] });
  canvas.mount({}, other);
  canvas.mount(owner, settings({ effects: [kept, gone, shared] }));
  canvas.unmount(owner);
  canvas.mount(owner, settings({ effects: [kept] }));
  await settled();
  expect([kept.freed, gone.freed, shared.freed, farol.isDisposed]).toEqual([0, 1, 0, false]);
  webgl.render(page, camera);
  expect(farol.effects).toEqual([kept]);
});
