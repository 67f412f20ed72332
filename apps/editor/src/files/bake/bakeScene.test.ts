import type { BakeOptions } from '@farol/bake';
import { GameObject, ObjectRenderer, Scene } from '@farol/engine';
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
