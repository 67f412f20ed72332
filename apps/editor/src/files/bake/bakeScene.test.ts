import type { BakeOptions } from '@farol/bake';
import { GameObject, Light, ObjectRenderer, Scene, soloLights } from '@farol/engine';
import type { WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { bakeScene } from './bakeScene';

/** Thrown by the fake baker to end the bake, with its options. */
class Asked extends Error {
  constructor(readonly options: BakeOptions) {
    super('asked');
  }
}

/** The options with which a scene is baked. */
async function optionsOf(scene: Scene): Promise<BakeOptions> {
  const baker = {
    bakeLightmaps: (_: unknown, __: unknown, options: BakeOptions) => Promise.reject(new Asked(options)),
  };
  const asked = { signal: new AbortController().signal, progressed: () => {}, warned: () => {} };
  const error = await bakeScene(baker as never, {} as WebGLRenderer, scene, asked).catch((reason: unknown) => reason);
  return (error as Asked).options;
}

test('a bake is asked for by the settings of the scene', async () => {
  const scene = new Scene();
  const floor = new GameObject('Floor');
  floor.isStatic = true;
  scene.add(floor);
  floor.addComponent(ObjectRenderer, { mesh: 'plane' });
  expect(await optionsOf(scene)).toMatchObject({
    ...{ size: 1024, samples: 256, bounces: 3, denoise: true, stitch: true, sky: 'none', texelsPerMetre: undefined },
  });
  Object.assign(scene.settings, { bakeSize: '64', bakeDenoise: false, bakeStitch: false, bakeTexelsPerMetre: 5 });
  expect(await optionsOf(scene)).toMatchObject({ size: 64, denoise: false, stitch: false, texelsPerMetre: 5 });
});

test('lights that are dark because others are shown alone are baked, and dark again after it', async () => {
  const scene = new Scene();
  for (const name of ['Floor', 'Lamp']) scene.add(new GameObject(name));
  const [floor, lamp] = scene.roots;
  floor.isStatic = true;
  floor.addComponent(ObjectRenderer, { mesh: 'plane' });
  const light = lamp.addComponent(Light, { mode: 'baked' });
  soloLights(scene, new Set(['another']));
  let visible = false;
  const baker = {
    bakeLightmaps: () => {
      visible = light.three.visible;
      return Promise.reject(new Error('enough'));
    },
  };
  const asked = { signal: new AbortController().signal, progressed: () => {}, warned: () => {} };
  await expect(bakeScene(baker as never, {} as WebGLRenderer, scene, asked)).rejects.toThrow('enough');
  expect([visible, light.three.visible]).toEqual([true, false]);
});
