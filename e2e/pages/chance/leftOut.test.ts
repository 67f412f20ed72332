import { expect, it } from 'vitest';
import { chooseScene } from './chooseScene';
import { leaveOut } from './leftOut';
import type { MaterialFacts, SceneFacts } from './SceneFacts';

const materialsOf = ({ world = {}, things = [] }: SceneFacts): MaterialFacts[] =>
  [world.override, ...things.map(({ material }) => material)].filter((material) => material !== undefined);

it('takes transmission from the material of a scene alone, for which three has no target', () => {
  const { world, things } = leaveOut({
    world: { override: { type: 'MeshPhysicalMaterial', transmission: 0.9, transmissionMap: 'grey', thickness: 1 } },
    things: [{ material: { type: 'MeshPhysicalMaterial', transmission: 0.9 } }],
  });
  expect(world?.override).toEqual({ type: 'MeshPhysicalMaterial', thickness: 1 });
  expect(things?.[0].material?.transmission).toBe(0.9);
});

it('takes anisotropy from wireframes alone, whose tangents are not defined', () => {
  const glossy = { type: 'MeshPhysicalMaterial', anisotropy: 0.9, anisotropyRotation: 1 };
  const { world, things } = leaveOut({
    world: { override: { ...glossy, wireframe: true } },
    things: [{ material: { ...glossy, wireframe: true } }, { material: glossy }],
  });
  const wires = { type: 'MeshPhysicalMaterial', wireframe: true };
  expect([world?.override, things?.[0].material]).toEqual([wires, wires]);
  expect(things?.[1].material).toEqual(glossy);
});

it.each([1729, 1733, 1824, 1831])('leaves nothing of that in the scene of seed %i', (seed) => {
  const isLeftOut = (material: MaterialFacts | undefined) =>
    material?.wireframe === true && material.anisotropy !== undefined;
  const chosen = chooseScene(seed);
  expect(materialsOf(chosen).some(isLeftOut) || chosen.world?.override?.transmission).toBeTruthy();
  const left = leaveOut(chosen);
  expect(materialsOf(left).some(isLeftOut)).toBe(false);
  expect(left.world?.override?.transmission).toBeUndefined();
});

it('has no floor of 40 m and more that is one polygon', () => {
  const floors = Array.from({ length: 100 }, (_, seed) => leaveOut(chooseScene(seed)).things![0]);
  const wide = floors.filter(({ scale }) => scale![0] >= 40);
  expect(wide.length).toBeGreaterThan(20);
  expect(new Set(wide.map(({ shape }) => shape))).toEqual(new Set(['tiles']));
});
