import { expect, test } from 'vitest';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { fogCode, FogVolume } from './FogVolume';

function volumeIn(scene: Scene, values: Parameters<GameObject['addComponent']>[1] = {}): FogVolume {
  const object = new GameObject('Mist');
  scene.add(object);
  return object.addComponent(FogVolume, values);
}

test('it is made once its code is there, if it is still in the scene', async () => {
  const scene = new Scene();
  const early = volumeIn(scene);
  const left = volumeIn(scene);
  scene.remove(left.gameObject);
  await fogCode.load();
  expect(early.three?.isFogVolume).toBe(true);
  expect(left.three).toBeNull();
});

test('its fields are those of the volume that the effect draws, also from a file', async () => {
  await fogCode.load();
  const scene = new Scene();
  const fog = volumeIn(scene, {
    shape: 'sphere',
    size: [2, 1, 3],
    density: -0.4,
    colour: [0.5, 0.25, 1],
    softness: 0.1,
  });
  fog.density = -0.5;
  const again = await deserialize(JSON.stringify(serialize(scene)));
  for (const each of [fog, again.componentsOf(FogVolume)[0]]) {
    const { three } = each;
    expect(three).toMatchObject({ shape: 'sphere', density: -0.5, softness: 0.1, visible: true });
    expect(three!.scale.toArray()).toEqual([2, 1, 3]);
    expect(three!.albedo.toArray()).toEqual([0.5, 0.25, 1]);
    expect(three!.parent).toBe(each.gameObject.object3D);
  }
  fog.enabled = false;
  expect(fog.three!.visible).toBe(false);
  scene.remove(fog.gameObject);
  expect(fog.three).toBeNull();
});
