import {
  type FarolEffect,
  type FarolEvents,
  type FarolRenderer,
  type TechniqueName,
  techniques,
} from '@farol/renderer';
import { loadEffects } from '@farol/renderer/effects';
import {
  Color,
  EventDispatcher,
  LinearToneMapping,
  NoToneMapping,
  PCFShadowMap,
  ReinhardToneMapping,
  type Vector4,
  VSMShadowMap,
} from 'three';
import { beforeAll, expect, test, vi } from 'vitest';
import { Camera } from '../components/Camera';
import { Light } from '../components/Light';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { PictureLook } from './PictureLook';
import { PictureRenderer } from './PictureRenderer';
import { toneMappings } from '../settings/toneMappings';

/** A renderer that only records its calls. */
function makeFarol(technique: TechniqueName) {
  const canvas = new EventTarget();
  const webgl = {
    domElement: canvas,
    toneMapping: NoToneMapping as number,
    toneMappingExposure: 1,
    getRenderTarget: () => null,
    getContextAttributes: () => ({ antialias: true }),
    getCurrentViewport: (viewport: Vector4) => viewport.set(0, 0, 4, 4),
    extensions: { has: () => true },
    shadowMap: { enabled: true, type: PCFShadowMap as number },
  };
  const farol = Object.assign(new EventDispatcher<FarolEvents>(), {
    webgl,
    view: 'final',
    shadowCascades: 1,
    technique: 'auto',
    quality: 'auto',
    effects: [] as FarolEffect[],
    techniques,
    info: { technique },
    /** Technique, tone mapping, exposure and background of each frame. */
    frames: [] as unknown[],
    render(scene: { background: unknown }): void {
      const { r } = scene.background as Color;
      this.frames.push([this.technique, webgl.toneMapping, webgl.toneMappingExposure, r]);
    },
  });
  return farol as unknown as FarolRenderer & typeof farol;
}

const names = ({ effects }: { effects: readonly FarolEffect[] }): string[] => effects.map(({ name }) => name);
const failed = (error: unknown): never => {
  throw error;
};

/** Copy of a scene, made by saving and opening it. */
const reopened = (scene: Scene): Promise<Scene> => deserialize(JSON.stringify(serialize(scene)));

// loaded beforehand, since it is large and would delay the first test
beforeAll(() => loadEffects() as Promise<unknown>);

test('technique and ambient occlusion are those of the scene, also after it was saved and opened again', async () => {
  const scene = new Scene();
  scene.settings.technique = 'deferred';
  scene.settings.ambientOcclusion = true;
  scene.settings.occlusionRadius = 2;
  const again = await reopened(scene);
  const farol = makeFarol('deferred');
  const picture = new PictureRenderer(farol, { failed });
  picture.render(again, {} as never);
  expect(farol.technique).toBe('deferred');
  await vi.waitFor(() => expect(names(farol)).toEqual(['ambient occlusion', 'SMAA']));
  expect(farol.effects[0]).toMatchObject({ radius: 2, strength: 1 });
  // another scene has its own
  picture.render(new Scene(), {} as never);
  expect(farol.technique).toBe('auto');
  expect(names(farol)).toEqual(['SMAA']);
});

test('with everything off a frame is what the renderer draws, and nothing is fetched or set', () => {
  const scene = new Scene();
  const farol = makeFarol('forward-single-pass');
  const redraw = vi.fn<() => void>();
  new PictureRenderer(farol, { redraw, failed }).render(scene, {} as never);
  expect(farol.frames).toEqual([['auto', NoToneMapping, 1, scene.settings.backgroundColour[0]]]);
  expect(redraw).not.toHaveBeenCalled();
  expect(farol.effects).toEqual([]);
});

test("tone mapping reaches the renderer for the frame alone, with the camera's own exposure, and the background too", async () => {
  const scene = new Scene();
  Object.assign(scene.settings, { toneMapping: 'reinhard', exposure: 2, backgroundColour: [0.25, 0.25, 0.25] });
  const camera = new Camera();
  scene.add(new GameObject('Camera').addComponent(camera).gameObject);
  camera.exposureCompensation = 1;
  const farol = makeFarol('forward-single-pass');
  const redraw = vi.fn<() => void>();
  const picture = new PictureRenderer(farol, { redraw, failed });
  picture.render(scene, camera.three, camera);
  expect(farol.frames[0]).toEqual(['auto', ReinhardToneMapping, 4, 0.25]);
  await vi.waitFor(() => expect(redraw).toHaveBeenCalled());
  picture.render(scene, camera.three, camera);
  // 4 × 0.25 = 1, which Reinhard maps to 0.5
  expect(farol.frames[1]).toEqual(['auto', ReinhardToneMapping, 4, 0.5]);
  expect((scene.three.background as Color).r).toBe(0.25);
  expect([farol.webgl.toneMapping, farol.webgl.toneMappingExposure]).toEqual([NoToneMapping, 1]);
});

test('exposure is by a number, an exposure value or a camera’s settings, which the camera’s own go before', () => {
  const scene = new Scene();
  const camera = new Camera();
  scene.add(new GameObject('Camera').addComponent(camera).gameObject);
  const farol = makeFarol('forward-single-pass');
  const picture = new PictureRenderer(farol, { failed });
  const exposureOf = (change: () => void): unknown => {
    change();
    picture.render(scene, camera.three, camera);
    return (farol.frames.at(-1) as unknown[]).slice(1, 3);
  };
  // without tone mapping an exposure factor has no effect; other exposures switch to the linear mapping
  expect(exposureOf(() => (scene.settings.exposure = 3))).toEqual([NoToneMapping, 1]);
  Object.assign(scene.settings, { exposureBy: 'value', exposureValue: 3 });
  expect(exposureOf(() => {})).toEqual([LinearToneMapping, 1 / (1.2 * 8)]);
  expect(exposureOf(() => (camera.exposureCompensation = 1))).toEqual([LinearToneMapping, 1 / (1.2 * 4)]);
  // sunny 16: EV 15
  Object.assign(camera, {
    exposureBy: 'camera',
    aperture: 16,
    shutterTime: 1 / 128,
    iso: 100,
    exposureCompensation: 0,
  });
  expect(exposureOf(() => {})).toEqual([LinearToneMapping, expect.closeTo(1 / (1.2 * 2 ** 15), 12)]);
  expect(exposureOf(() => (scene.settings.toneMapping = 'reinhard'))).toEqual([ReinhardToneMapping, expect.anything()]);
});

test('effects forget the frames that they have gathered when tones change, and not else', async () => {
  const scene = new Scene();
  scene.settings.antialiasing = 'taa';
  const camera = new Camera();
  scene.add(new GameObject('Camera').addComponent(camera).gameObject);
  const farol = makeFarol('forward-single-pass');
  const picture = new PictureRenderer(farol, { failed });
  picture.render(scene, camera.three, camera);
  await vi.waitFor(() => expect(names(farol)).toEqual(['TAA']));
  picture.render(scene, camera.three, camera);
  const reset = vi.spyOn(farol.effects[0] as Required<FarolEffect>, 'reset');
  const forgets = (change: () => void): number => {
    change();
    for (let i = 0; i < 2; i++) picture.render(scene, camera.three, camera);
    const { length } = reset.mock.calls;
    reset.mockClear();
    return length;
  };
  expect(forgets(() => (scene.settings.exposure = 2))).toBe(0); // exposure has an effect only with tone mapping
  expect(forgets(() => (scene.settings.toneMapping = 'reinhard'))).toBe(1);
  expect(forgets(() => (scene.settings.exposure = 3))).toBe(1);
  expect(forgets(() => (camera.exposureCompensation = 1))).toBe(1);
  expect(forgets(() => (camera.toneMapping = 'agx'))).toBe(1);
  expect(forgets(() => (camera.fov = 1))).toBe(0);
  expect(forgets(() => (camera.toneMapping = 'none'))).toBe(1);
});

test('a technique that is not there is told once, and the default draws until it comes', () => {
  const scene = new Scene();
  scene.settings.technique = 'glow';
  const farol = makeFarol('forward-single-pass');
  let technique = 'auto';
  const known = new Set(['auto']);
  Object.defineProperty(farol, 'technique', {
    get: () => technique,
    set(name: string) {
      if (!known.has(name)) throw new Error(`no ${name}`);
      technique = name;
    },
  });
  const told = vi.fn<(error: unknown) => void>();
  const picture = new PictureRenderer(farol, { failed: told });
  picture.render(scene, {} as never);
  picture.render(scene, {} as never);
  expect(told).toHaveBeenCalledTimes(1);
  expect(technique).toBe('auto');
  known.add('glow');
  picture.retakeTechnique();
  picture.render(scene, {} as never);
  expect(technique).toBe('glow');
});

test('edges are smoothed by SMAA where a G-buffer is shaded, unless the scene says otherwise or pictures are compared', async () => {
  const scene = new Scene();
  const farol = makeFarol('deferred');
  const { effects } = new PictureRenderer(farol, { failed });
  effects.update(scene.settings);
  await vi.waitFor(() => expect(names(farol)).toEqual(['SMAA']));
  effects.suspended = true;
  expect(names(farol)).toEqual([]);
  effects.suspended = false;
  scene.settings.antialiasing = 'taa';
  effects.update(scene.settings);
  await vi.waitFor(() => expect(names(farol)).toEqual(['TAA']));
  expect(effects.frames).toBeGreaterThan(1);
  scene.settings.antialiasing = 'none';
  effects.update(scene.settings);
  expect(names(farol)).toEqual([]);
  expect(effects.frames).toBe(1);
});

test('a technique that cannot occlude goes without, and effects of plugins come and go by name', async () => {
  const scene = new Scene();
  const farol = makeFarol('forward-single-pass');
  const { effects } = new PictureRenderer(farol, { failed });
  Object.assign(scene.settings, { ambientOcclusion: true, pluginEffects: 'haze, unheard of' });
  farol.technique = 'forward';
  effects.update(scene.settings);
  expect(names(farol)).toEqual([]);
  const dispose = vi.fn<() => void>();
  effects.added.set('haze', () => ({ name: 'Haze', dispose }) as unknown as FarolEffect);
  effects.addedChanged();
  await vi.waitFor(() => expect(names(farol)).toEqual(['Haze']));
  effects.added.clear();
  effects.addedChanged();
  expect(names(farol)).toEqual([]);
  expect(dispose).toHaveBeenCalledTimes(1);
});

test('kind, cascades and softness of shadows, and quality are those of the scene, also after it was saved and opened again', async () => {
  const scene = new Scene();
  Object.assign(scene.settings, { shadowKind: 'variance', shadowCascades: 3, shadowSoftness: 2, quality: 'lite' });
  const lamp = new GameObject('Lamp');
  lamp.addComponent(Light, { castShadow: true, shadowRadius: 1.5 });
  scene.add(lamp);
  const again = await reopened(scene);
  const farol = makeFarol('forward-single-pass');
  const { shadowMap } = farol.webgl;
  const picture = new PictureRenderer(farol, { failed });
  const look = (of: Scene): unknown[] => {
    picture.render(of, {} as never);
    return [shadowMap.enabled, shadowMap.type, farol.shadowCascades, farol.quality];
  };
  expect(look(again)).toEqual([true, VSMShadowMap, 3, 'lite']);
  const [light] = again.componentsOf(Light);
  const radius = (): number | undefined => (light.three as { shadow?: { radius: number } }).shadow?.radius;
  expect(radius()).toBe(3);
  again.settings.shadowSoftness = 0.5;
  expect(radius()).toBe(0.75);
  light.shadowRadius = 4;
  expect(radius()).toBe(2);
  again.settings.shadowKind = 'none';
  expect(look(again)[0]).toBe(false);
  expect(look(new Scene())).toEqual([true, PCFShadowMap, 1, 'auto']);
});

test('a camera has the focus of the scene, none, or its own', () => {
  const { settings } = new Scene();
  const look = new PictureLook();
  const camera = new Camera();
  Object.assign(settings, { depthOfField: true, focusDistance: 7, toneMapping: 'agx' });
  expect(look.follow(settings, null)).toMatchObject({ depthOfField: true, focusDistance: 7 });
  expect(look.follow(settings, camera)).toMatchObject({ depthOfField: true, toneMapping: toneMappings.agx });
  camera.set('depthOfField', 'off');
  expect(look.follow(settings, camera).depthOfField).toBe(false);
  settings.depthOfField = false;
  camera.set('depthOfField', 'own');
  camera.set('focusDistance', 3);
  camera.set('toneMapping', 'none');
  expect(look.follow(settings, camera)).toMatchObject({
    depthOfField: true,
    focusDistance: 3,
    toneMapping: NoToneMapping,
  });
});

test('skies light and fill the scene until there is another background; fog takes their colour', async () => {
  const scene = new Scene();
  const { settings, three } = scene;
  settings.background = 'sky';
  settings.sky = 'sunset';
  await settings.skyReady;
  const sky = three.background;
  expect(three.environment).toBe(sky);
  settings.fog = 'linear';
  settings.fogFromSky = true;
  expect(three.fog!.color.r).toBeGreaterThan(three.fog!.color.b);
  settings.bloom = true;
  expect(three.background).toBe(sky);
  settings.skyLight = false;
  expect([three.background, three.environment]).toEqual([sky, null]);
  const again = await reopened(scene);
  expect(again.three.background).toMatchObject({ isTexture: true });
  const gone = vi.fn<() => void>();
  (sky as unknown as EventTarget).addEventListener('dispose', gone);
  settings.background = 'colour';
  expect(gone).toHaveBeenCalledTimes(1);
  expect(three.background).toBeInstanceOf(Color);
});
