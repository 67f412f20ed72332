import { builtinComponents, ComponentRegistry, Light, Scene } from '@farol/engine';
import { expect, test } from 'vitest';
import { creations } from './creations';

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
