import { AssetLibrary, builtinComponents, ComponentRegistry, Light, Scene } from '@farol/engine';
import { expect, test } from 'vitest';
import { creations } from './creations';
import { makeEmptyScene } from './makeEmptyScene';

test('the Add menu has the objects that component classes name, and not those of classes that they extend', async () => {
  class Lamp extends Light {
    static override readonly typeName: string = 'Lamp';
  }
  class Torch extends Light {
    static override readonly typeName: string = 'Torch';
    static override readonly newObjects = [{ label: 'Torch', group: 'light' as const, values: { intensity: 7 } }];
  }
  const builtin = creations(new Scene());
  const registry = new ComponentRegistry([...builtinComponents.types.values(), Lamp, Torch]);
  const all = creations(new Scene({ registry }));
  expect(all.length).toBe(builtin.length + 1);
  const torch = await all.find(({ label }) => label === 'Torch')!.make();
  expect(torch.name).toBe('Torch');
  expect(torch.getComponent(Torch)!.intensity).toBe(7);
});

test('a wall and a room are drawn', async () => {
  const buildings = creations(new Scene()).filter(({ group }) => group === 'building');
  const made = await Promise.all(buildings.map(({ make }) => make()));
  const types = made.map(({ components }) => components.map(({ typeName }) => typeName));
  expect(types).toEqual([
    ['Transform', 'Wall', 'ObjectRenderer'],
    ['Transform', 'Room', 'ObjectRenderer'],
  ]);
});

test("shadows of a new document's sun end out of sight, and are fine near the camera", async () => {
  const scene = makeEmptyScene(new AssetLibrary());
  const sun = scene.find('Sun')!.getComponent(Light)!;
  expect(sun.shadowExtent).toBeGreaterThanOrEqual(100);
  // distance between texels of the finest map (m)
  expect((2 * sun.shadowExtent) / sun.shadowMapSize / 4 ** (scene.settings.shadowCascades - 1)).toBeLessThan(0.02);
  // distance that the bias moves shadows by (m)
  expect(-sun.shadowBias * 8 * sun.shadowExtent).toBeLessThan(0.1);
  const added = await creations(scene)
    .find(({ label }) => label === 'Directional light')!
    .make();
  expect(added.getComponent(Light)!.shadowExtent).toBeGreaterThanOrEqual(50);
});
