import { AdditiveBlending, MultiplyBlending, NormalBlending, SubtractiveBlending } from 'three';
import { expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { Decal } from './Decal';
import { decalCode } from './decalCode';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';

function decalIn(scene: Scene, values: Parameters<GameObject['addComponent']>[1] = {}): Decal {
  const object = new GameObject('Stain');
  scene.add(object);
  return object.addComponent(Decal, values);
}

test('it is made once its code is there, if it is still in the scene', async () => {
  const scene = new Scene();
  const early = decalIn(scene);
  const left = decalIn(scene);
  scene.remove(left.gameObject);
  expect(decalCode.code).toBeNull();
  expect(early.three).toBeNull();
  await decalCode.load();
  expect(early.three).not.toBeNull();
  expect(left.three).toBeNull();
});

test('its fields are those of the decal that the effect draws', () => {
  const scene = new Scene();
  const decal = decalIn(scene, { size: [2, 1, 0.25], colour: [0, 0.5, 1], opacity: 0.4, order: 3, map: 'checker' });
  const { three } = decal;
  expect(three!.isDecal).toBe(true);
  expect(three!.parent).toBe(decal.gameObject.object3D);
  expect(three!.scale.toArray()).toEqual([2, 1, 0.25]);
  expect(three!.renderOrder).toBe(3);
  expect(three!.surface.color.toArray()).toEqual([0, 0.5, 1]);
  expect(three!.surface.opacity).toBe(0.4);
  expect(three!.surface.map).not.toBeNull();
  decal.roughness = 0.1;
  decal.size = [1, 1, 1];
  decal.map = null;
  expect(three!.surface.roughness).toBe(0.1);
  expect(three!.surface.map).toBeNull();
  expect(three!.scale.x).toBe(1);
  decal.enabled = false;
  expect(three!.visible).toBe(false);
});

test('decals of equal looks share a material, which goes with the last; the scene lists them', () => {
  const assets = new AssetLibrary();
  const scene = new Scene({ assets });
  const [a, b] = [decalIn(scene, { roughness: 0.2 }), decalIn(scene, { roughness: 0.2 })];
  expect(a.three!.surface).toBe(b.three!.surface);
  expect(scene.componentsOf(Decal)).toEqual([a, b]);
  scene.remove(a.gameObject);
  b.gameObject.removeComponent(b);
  expect(scene.componentsOf(Decal)).toEqual([]);
  expect(a.three).toBeNull();
  expect(assets.materials.size).toBe(0);
});

test('its blending is three’s, and looks that differ by it alone share no material', () => {
  const scene = new Scene();
  const decal = decalIn(scene);
  const other = decalIn(scene);
  expect(decal.three!.surface.blending).toBe(NormalBlending);
  for (const [name, constant] of [
    ['additive', AdditiveBlending],
    ['subtractive', SubtractiveBlending],
    ['multiply', MultiplyBlending],
  ] as const) {
    decal.blending = name;
    expect(decal.three!.surface.blending).toBe(constant);
    expect(other.three!.surface.blending).toBe(NormalBlending);
  }
  decal.blending = 'normal';
  expect(decal.three!.surface).toBe(other.three!.surface);
});

test('its blending is kept in files; a file from before there was any is read as ever', async () => {
  const scene = new Scene();
  decalIn(scene, { blending: 'multiply' });
  const file = serialize(scene);
  const [written] = file.objects[0].components.filter(({ type }) => type === 'Decal');
  expect(written.values.blending).toBe('multiply');
  expect((await deserialize(file)).componentsOf(Decal)[0].blending).toBe('multiply');
  delete written.values.blending;
  expect((await deserialize(file)).componentsOf(Decal)[0].blending).toBe('normal');
});
