import {
  AssetLibrary,
  GameObject,
  Light,
  type Model,
  ModelRenderer,
  objectsOfModel,
  ParticleEmitter,
  Scene,
} from '@farol/engine';
import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import { packGltf } from '@farol/engine/files';
import { type PhotometricProfile, writeIES } from '@farol/renderer/light-profiles';
import { type Object3D, type PointLight, Vector3 } from 'three';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import { exportInTest, PageFileReader, partsOfGlb } from './testing/exportInTest';

beforeAll(() => void vi.stubGlobal('FileReader', PageFileReader));
afterAll(() => void vi.unstubAllGlobals());

const NAME = 'EXT_lights_ies';
interface Exported {
  readonly nodes: readonly { readonly name?: string; readonly extensions?: Record<string, object> }[];
  readonly extensionsUsed: readonly string[];
  readonly extensions?: Record<string, { readonly lights: readonly object[] }>;
}

async function read(blob: Blob): Promise<{ assets: AssetLibrary; model: Model }> {
  const assets = new AssetLibrary();
  assets.registerFile('lamps.glb', blob);
  await assets.load('lamps.glb');
  return { assets, model: assets.model('lamps.glb') };
}

/** Tilted lamps, one of them with an end and a colour beyond glTF's range. */
async function litScene(): Promise<Scene> {
  const scene = new Scene();
  await Promise.all(['profile/street-light', 'profile/downlight'].map((name) => scene.assets.load(name)));
  const add = (name: string, rotation: Vector3Tuple, values: Readonly<Record<string, FieldValue>>): void => {
    const object = new GameObject(name);
    Object.assign(object.transform, { position: [1, 3, 2], rotation });
    scene.add(object);
    object.addComponent(Light, values);
  };
  add('Street', [0.3, 1.1, -0.4], {
    profile: 'profile/street-light',
    profileIntensity: true,
    intensity: 0.75,
    range: 0,
  });
  add('Down', [-0.8, 0, 0.2], { profile: 'profile/downlight', intensity: 120, diffuse: [3, 1.5, 0.75], range: 8 });
  add('Spot', [0.1, 0.6, 0], { type: 'spot', profile: 'profile/street-light', intensity: 90, range: 0, cutoff: 0.5 });
  return scene;
}

/** World directions of down and across of a light's profile, as defined by `LightOptions.profile`. */
function frameOf(light: PointLight): Vector3[] {
  light.updateWorldMatrix(true, false);
  const [across, up, back] = [new Vector3(), new Vector3(), new Vector3()];
  light.matrixWorld.extractBasis(across, up, back);
  return [across, ('isSpotLight' in light ? back : up).negate()];
}

const lightBelow = (root: Object3D): PointLight => {
  let found: Object3D | null = null;
  root.traverse((each) => 'isLight' in each && (found = each));
  return found! as PointLight;
};

function expectAlike(
  found: PointLight,
  source: PointLight,
  profile: PhotometricProfile,
  wanted: PhotometricProfile,
): void {
  frameOf(found).forEach((axis, i) => expect(axis.distanceTo(frameOf(source)[i])).toBeLessThan(1e-6));
  expect(profile.data).toMatchObject({ ...wanted.data, version: profile.data.version, tilt: null });
  for (const channel of ['r', 'g', 'b'] as const)
    expect(found.color[channel] * found.intensity).toBeCloseTo(source.color[channel] * source.intensity, 4);
  expect(found.distance).toBe(source.distance);
}

test('lights with a profile are exported with it, and come back as they were, drawn whole or unpacked', async () => {
  const scene = await litScene();
  const { blob, leftOut } = await exportInTest(scene);
  expect(leftOut.filter((line) => line.includes('profile'))).toEqual([
    'Lights with a profile have an end in Farol alone; elsewhere they go on (1)',
    'Cones of lights with a profile are left out (1)',
  ]);
  const { json } = await partsOfGlb<Exported>(blob);
  expect(json.extensionsUsed).toContain(NAME);
  expect(json.extensions![NAME].lights).toEqual([
    expect.objectContaining({ mimeType: 'application/x-ies-lm-63', bufferView: expect.any(Number) }),
    expect.objectContaining({ mimeType: 'application/x-ies-lm-63' }),
  ]);
  const given = json.nodes.flatMap(({ extensions }) => extensions?.[NAME] ?? []);
  expect(given[0]).toEqual({ light: 0, multiplier: 0.75 });
  expect(given[1]).toMatchObject({ light: 1, color: [1, 0.5, 0.25] });

  const { model, assets } = await read(blob);
  const whole = new Scene({ assets });
  const holder = new GameObject('Lamps');
  whole.add(holder);
  const drawn = holder.addComponent(ModelRenderer, { model: 'lamps.glb' });
  const unpacked = new Scene({ assets });
  for (const object of objectsOfModel(model, assets, 'lamps.glb').objects) unpacked.add(object);
  for (const name of ['Street', 'Down', 'Spot']) {
    const source = scene.find(name)!.getComponent(Light)!;
    const wanted = scene.assets.profile(source.profile!);
    const inModel = lightBelow(drawn.three!.getObjectByName(name)!);
    expectAlike(inModel, source.three as PointLight, model.profileOf(inModel)!, wanted);
    const found = [...unpacked.componentsOf(Light)].find((light) => {
      for (let each: GameObject | null = light.gameObject; each; each = each.parent)
        if (each.name === name) return true;
      return false;
    })!;
    expect(found.profile).toMatch(/^lamps\.glb\/profile-[12]/);
    expectAlike(found.three as PointLight, source.three as PointLight, assets.profile(found.profile!), wanted);
  }
  for (const again of [whole, unpacked]) {
    const second = await partsOfGlb<Exported>((await exportInTest(again)).blob);
    const seen = second.json.nodes.flatMap(({ extensions }) => extensions?.[NAME] ?? []);
    expect(seen).toEqual(given.map((each) => expect.objectContaining({ light: (each as { light: number }).light })));
  }
});

test('profiles in files beside a glTF are packed; what is wrong is said', async () => {
  const scene = await litScene();
  const text = writeIES(scene.assets.profile('profile/downlight'));
  const gltf = (lights: object[], node: object): ArrayBuffer =>
    new TextEncoder().encode(
      JSON.stringify({
        ...{ asset: { version: '2.0' }, extensionsUsed: [NAME], extensions: { [NAME]: { lights } }, scene: 0 },
        ...{ scenes: [{ nodes: [0] }], nodes: [{ name: 'Lamp', extensions: { [NAME]: node } }] },
      }),
    ).buffer;
  const beside = gltf([{ uri: 'lamp.ies', name: 'Downlight' }], { light: 0 });
  const packed = await packGltf(beside, async () => new TextEncoder().encode(text).buffer);
  const { model } = await read(new Blob([packed]));
  expect(model.profiles.map(({ name, maximumIntensity }) => [name, maximumIntensity])).toEqual([
    ['Downlight', scene.assets.profile('profile/downlight').maximumIntensity],
  ]);
  const inside = await read(new Blob([gltf([{ uri: `data:;base64,${btoa(text)}` }], { light: 0, multiplier: 2 })]));
  expect(lightBelow(inside.model.scene).intensity).toBe(2 * inside.model.profiles[0].maximumIntensity);
  const problems: [object[], object, RegExp][] = [
    [[{ uri: 'lamp.ies' }], { light: 0 }, /it needs lamp\.ies/],
    [[{ uri: 'data:,none' }], { light: 0 }, /light profile 0 cannot be read \(.*TILT=/],
    [[{ bufferView: 3 }], { light: 0 }, /light profile 0 names the buffer view 3/],
    [[], { light: 0 }, /node 0 names the light profile 0, and there are 0/],
    [[{ uri: `data:;base64,${btoa(text)}` }], { light: 0, multiplier: -1 }, /the multiplier of node 0 is -1/],
  ];
  for (const [lights, node, problem] of problems)
    await expect(read(new Blob([gltf(lights, node)]))).rejects.toThrow(problem);
});

test('particles that are left out are named once', async () => {
  const scene = new Scene();
  for (const name of ['Fire', 'Smoke']) {
    const object = new GameObject(name);
    scene.add(object);
    object.addComponent(ParticleEmitter);
  }
  expect((await exportInTest(scene)).leftOut).toEqual([
    'Particles and the light that they give are left out: Fire, Smoke (2)',
    'The background is left out',
  ]);
});
