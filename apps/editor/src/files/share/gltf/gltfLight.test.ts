import { AssetLibrary, GameObject, Light, type Model, objectsOfModel, Scene } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import type { PointLight, SpotLight } from 'three';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import { exportInTest, PageFileReader, partsOfGlb } from './testing/exportInTest';

beforeAll(() => void vi.stubGlobal('FileReader', PageFileReader));
afterAll(() => void vi.unstubAllGlobals());

type Exported = { nodes: { name: string; extras?: object }[] };

const lights: Readonly<Record<string, Readonly<Record<string, FieldValue>>>> = {
  nearFar: {
    ...{ type: 'point', attenuation: 'near-far', near: 2, far: 7, intensity: 3, diffuse: [4, 1, 0.5] },
    ambient: [0.25, 2, 0.125],
  },
  polynomial: {
    type: 'spot',
    attenuation: 'polynomial',
    constant: 1,
    linear: 0.5,
    quadratic: 0.25,
    range: 9,
    cutoff: 0.4,
  },
  linear: { type: 'point', decay: 1, range: 12, intensity: 5 },
  exponent: { type: 'spot', exponent: 8, ambient: [0.5, 0.25, 0], ownSpecular: true, specular: [0, 1, 0], range: 6 },
  physical: { type: 'point', intensity: 9, range: 4 },
};

async function read(blob: Blob): Promise<{ assets: AssetLibrary; model: Model }> {
  const assets = new AssetLibrary();
  assets.registerFile('lights.glb', blob);
  await assets.load('lights.glb');
  return { assets, model: assets.model('lights.glb') };
}

function litScene(): Scene {
  const scene = new Scene();
  for (const [name, values] of Object.entries(lights)) {
    const object = new GameObject(name);
    object.addComponent(Light, values);
    scene.add(object);
  }
  return scene;
}

async function exported(): Promise<{ scene: Scene; model: Model; leftOut: readonly string[]; json: Exported }> {
  const scene = litScene();
  const { blob, leftOut } = await exportInTest(scene);
  const { json } = await partsOfGlb<Exported>(blob);
  return { scene, model: (await read(blob)).model, leftOut, json };
}

test('lights of the thesis survive the export as extras, with a warning, and come back as they were', async () => {
  const { scene, model, leftOut, json } = await exported();
  expect(leftOut.filter((line) => /[lL]ights/.test(line))).toEqual([
    'Lights that fade in a way of their own do so in Farol alone; elsewhere they fade as in nature, as bright half way (3)',
    'Spot lights with an exponent keep it in Farol alone; elsewhere they have an edge (1)',
  ]);
  const found: Record<string, PointLight> = {};
  model.scene.traverse((object) => {
    if (!('isLight' in object)) return;
    let named = object.parent!;
    while (named.parent !== null && !(named.name in lights)) named = named.parent;
    found[object.name in lights ? object.name : named.name] = object as PointLight;
  });
  expect(Object.keys(found).toSorted()).toEqual(Object.keys(lights).toSorted());
  for (const [name, light] of Object.entries(found)) {
    const source = scene.find(name)!.getComponent(Light)!.three as SpotLight;
    const { color, intensity } = light;
    expect(light.userData.farolLight, name).toBeUndefined();
    for (const channel of ['r', 'g', 'b'] as const) {
      expect(color[channel] * intensity).toBeCloseTo(source.color[channel] * source.intensity, 5);
    }
    expect([light.distance, light.decay]).toEqual([source.distance, source.decay]);
    const own = source.userData.farol as { ambient?: number[]; attenuation?: object } | undefined;
    expect(light.userData.farol?.attenuation).toEqual(own?.attenuation);
    expect(light.userData.farol?.spotExponent).toBe(name === 'exponent' ? 8 : undefined);
    if (own?.ambient) expect(light.userData.farol.ambient).toEqual(own.ambient);
  }
  const { nodes } = json;
  expect(nodes.filter(({ extras }) => extras !== undefined)).toHaveLength(4);
});

test('lights of the thesis come back as components with the same fields, and are exported as the same again', async () => {
  const first = litScene();
  const { blob } = await exportInTest(first);
  const { model, assets } = await read(blob);
  const second = new Scene();
  for (const object of objectsOfModel(model, assets, 'lights.glb').objects) second.add(object);
  const found = second.componentsOf(Light);
  expect([...found]).toHaveLength(Object.keys(lights).length);
  const fieldsOf = (light: Light) => {
    const { type, diffuse, intensity, ambient, ownSpecular, specular, exponent, attenuation } = light;
    const { range, decay, near, far, constant, linear, quadratic } = light;
    const ways = { attenuation, range, decay, near, far, constant, linear, quadratic };
    return { type, diffuse, intensity, ambient, ownSpecular, specular, exponent, ...ways };
  };
  const nameOf = (light: Light) => {
    let { gameObject } = light;
    while (!(gameObject.name in lights)) gameObject = gameObject.parent!;
    return gameObject.name;
  };
  for (const light of found) {
    const name = nameOf(light);
    expect(fieldsOf(light), name).toEqual(fieldsOf(first.find(name)!.getComponent(Light)!));
  }
  const extrasOf = async (scene: Scene) => {
    const { json } = await partsOfGlb<Exported>((await exportInTest(scene)).blob);
    return json.nodes.flatMap(({ extras }) => extras ?? []);
  };
  expect(await extrasOf(second)).toEqual(await extrasOf(first));
});

test('extras that are no light are left alone', async () => {
  const { restoreLights } = await import('@farol/engine/files');
  const { PointLight: Point } = await import('three');
  const light = new Point(0xffffff, 2, 3);
  for (const farolLight of [
    7,
    null,
    { intensity: 'x', decay: -1, data: { attenuation: { kind: 'near-far', near: 1 } } },
    { data: { ambient: [1, 2] }, color: [1, -1, 0] },
  ]) {
    light.userData.farolLight = farolLight;
    restoreLights(light);
    expect(light.color.getHex()).toBe(0xffffff);
    expect([light.intensity, light.distance, light.decay, light.userData.farol]).toEqual([2, 3, 2, undefined]);
  }
});
