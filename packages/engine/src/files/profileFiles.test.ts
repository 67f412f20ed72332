import { readFileSync } from 'node:fs';
import { type PointLight, SpotLight } from 'three';
import { expect, test } from 'vitest';
import '../components/index';
import { AssetLibrary } from '../assets/AssetLibrary';
import { Light } from '../components/Light';
import { GameObject } from '../core/GameObject';
import { shownIntensity } from '../photometry/shownIntensity';
import { Scene } from '../core/Scene';
import { containerContent, inlineAssets, writeContainer } from './container';
import { deserialize } from './deserialize';
import { readSceneFile } from './readSceneFile';
import { serialize } from './serialize';

const NAME = 'Lamps/trough.ies';
const bytes = readFileSync(
  new URL('../../../renderer/src/light-profiles/testing/lm63-1991-quadrants.ies', import.meta.url),
);

async function litScene(): Promise<{ scene: Scene; light: Light }> {
  const scene = new Scene();
  scene.assets.registerFile(NAME, new Blob([bytes]));
  const object = new GameObject('Lamp');
  const light = object.addComponent(Light, { profile: NAME, intensity: 0.5 });
  scene.add(object);
  await scene.assets.load(NAME);
  return { scene, light };
}

const textureOf = (light: Light): unknown => light.three.userData.farolProfile ?? null;

test('a profile is kept in files and links, its bytes as they are, and scales the light of what comes back', async () => {
  const { scene } = await litScene();
  expect(scene.assets.typeOf(NAME)).toBe('profile');
  const content = containerContent(scene);
  const { text, fileOf } = await readSceneFile(await writeContainer(content));
  const fromFile = await deserialize(text, { assets: new AssetLibrary(), fileOf });
  expect(serialize(fromFile)).toEqual(serialize(scene));
  const fromLink = await deserialize(JSON.stringify(await inlineAssets(content)), { assets: new AssetLibrary() });
  for (const copy of [fromFile, fromLink]) {
    await copy.assets.load(NAME);
    const light = copy.find('Lamp')!.getComponent(Light)!;
    expect(textureOf(light)).toBe(copy.assets.profile(NAME).texture);
    expect(copy.assets.profile(NAME).maximumIntensity).toBe(48);
  }
});

test('lumens of a light with a profile are those of its file, dimmed as its intensity is', async () => {
  const { scene, light } = await litScene();
  const { luminousFlux } = scene.assets.profile(NAME);
  light.intensityUnit = 'lumen';
  // 0.5 cd, where the file's largest value is 48 cd
  expect(shownIntensity(light).value).toBeCloseTo((luminousFlux * 0.5) / 48, 6);
  expect(light.profileSolidAngle).toBeCloseTo(luminousFlux / 48, 6);
  light.profile = null;
  expect(shownIntensity(light).value).toBeCloseTo(2 * Math.PI, 6);
});

test('the profile of a light follows its fields, and gives the brightness where that is asked for', async () => {
  const { scene, light } = await litScene();
  const { texture } = scene.assets.profile(NAME);
  expect([textureOf(light), light.three.intensity]).toEqual([texture, 0.5]);
  light.profileIntensity = true;
  expect(light.three.intensity).toBe(24);
  light.type = 'spot';
  expect(light.three).toBeInstanceOf(SpotLight);
  expect([textureOf(light), light.three.intensity]).toEqual([texture, 24]);
  light.type = 'directional';
  expect([textureOf(light), light.three.intensity]).toEqual([null, 0.5]);
  light.type = 'point';
  light.profile = null;
  expect([textureOf(light), light.three.intensity]).toEqual([null, 0.5]);
  expect((light.three as PointLight).isPointLight).toBe(true);
});

test('a file that is no photometric one is told by its line', async () => {
  const { assets } = new Scene();
  assets.registerFile('broken.ies', new Blob(['IESNA91\nTILT=NONE\n1 1000 many']));
  await expect(assets.load('broken.ies')).rejects.toThrow(
    /Line 3: "many" is not a number; write the candela multiplier/,
  );
});

test.each(['profile/downlight', 'profile/wall-washer', 'profile/street-light'])(
  '%s comes with the library, and shines down alone',
  async (name) => {
    const { assets } = new Scene();
    expect([assets.typeOf(name), assets.isBuiltin(name)]).toEqual(['profile', true]);
    await assets.load(name);
    const profile = assets.profile(name);
    expect(profile.luminousFlux).toBeGreaterThan(200);
    expect(profile.luminousFlux).toBeLessThan(20_000);
    expect(profile.intensityAt(91, 90)).toBeLessThan(1e-9);
    expect(profile.intensityAt(135, 0)).toBe(0);
    expect(profile.texture.image.width).toBeLessThan(400);
  },
);
