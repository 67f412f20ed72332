import * as engine from '@farol/engine';
import {
  builtinComponents,
  CharacterController,
  ComponentRegistry,
  type GameObject,
  Light,
  PhysicsSystem,
  Scene,
} from '@farol/engine';
import * as fields from '@farol/engine/fields';
import { instantiatePrefab } from '@farol/engine/prefabs';
import { compileScript, SceneScripts, takeGiven } from '@farol/engine/scripts';
import * as three from 'three';
import { afterEach, expect, test } from 'vitest';
import { buildLibraryItem } from './buildLibraryItem';

const scenes: Scene[] = [];
afterEach(() => {
  for (const scene of scenes.splice(0)) scene.dispose();
});

/** A scene with items of the library, and their scripts running. */
async function sceneOf(...ids: string[]): Promise<{ scene: Scene; items: GameObject[] }> {
  const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const scene = new Scene({ registry });
  scenes.push(scene);
  const items = ids.map((id) => {
    const { prefab, assets } = buildLibraryItem(id)!;
    for (const { name, type, values } of assets)
      if (!scene.assets.has(name)) scene.assets.addFieldAsset(type as 'material', name, values!);
    return instantiatePrefab(prefab, registry);
  });
  for (const item of items) scene.add(item);
  const scripts = new SceneScripts(scene, registry, {
    modules: { three, '@farol/engine': engine, '@farol/engine/fields': fields },
    compile: compileScript,
    run: ({ name, code }) => {
      // oxlint-disable-next-line no-eval -- runs code as a page's script element does
      (0, eval)(code);
      return takeGiven(name);
    },
  });
  await scripts.settled();
  expect([...scripts.errors.values()]).toEqual([]);
  scene.onComponentError = (component, error) => {
    throw new Error(`${component.typeName}: ${String(error)}`);
  };
  scene.setTime(0);
  if (scene.componentsOf('Collider').length > 0) await scene.system(PhysicsSystem).prepare();
  return { scene, items };
}

const run = (scene: Scene, seconds: number): void => {
  for (let i = 0; i < seconds * 60; i++) scene.update(1 / 60);
};

test('a door opens when the player comes near, closes behind, and is shut after a reset', async () => {
  const { scene, items } = await sceneOf('ground', 'player', 'door');
  const [, player, door] = items;
  player.transform.position = [0, 0, 6];
  const hinge = door.children.find(({ name }) => name === 'Hinge')!;
  const walk = player.getComponent(CharacterController)!;
  run(scene, 1);
  expect([hinge.object3D.rotation.y, Math.abs(player.object3D.position.y) < 0.05]).toEqual([0, true]);
  walk.walk([0, 0, -1]);
  run(scene, 2.5);
  expect(hinge.object3D.rotation.y).toBeGreaterThan(1);
  // the player walks through the open door, and away
  run(scene, 2.5);
  expect(player.object3D.position.z).toBeLessThan(-4);
  expect(hinge.object3D.rotation.y).toBeLessThan(0.05);
  scene.reset();
  expect([hinge.object3D.rotation.y, player.object3D.position.z]).toEqual([0, 6]);
});

test('a lamp flickers below its authored brightness, another follows the player, a guard goes round its way', async () => {
  const { scene, items } = await sceneOf('flicker', 'follow', 'patrol', 'player');
  const [flicker, follow, patrol, player] = items;
  player.transform.position = [8, 0, 0];
  const lamp = flicker.children.flatMap((child) => child.getComponent(Light) ?? [])[0];
  const guard = patrol.children[0];
  const seen = new Set<number>();
  for (let i = 0; i < 30; i++) {
    scene.update(1 / 60);
    expect(lamp.intensity).toBeLessThanOrEqual(6);
    seen.add(lamp.intensity);
  }
  expect(seen.size).toBeGreaterThan(10);
  run(scene, 3);
  expect(8 - follow.object3D.position.x).toBeCloseTo(1.5, 1);
  expect(follow.object3D.position.y).toBeCloseTo(1.8, 1);
  // past the first point of its path
  expect(guard.object3D.position.x).toBeCloseTo(2, 1);
  expect(Math.abs(guard.object3D.position.z)).toBeLessThan(1.9);
  scene.reset();
  expect([lamp.intensity, follow.object3D.position.x, guard.object3D.position.x]).toEqual([6, 0, 0]);
});
