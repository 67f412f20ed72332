import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import * as engine from '@farol/engine';
import {
  builtinComponents,
  CharacterController,
  ComponentRegistry,
  type GameObject,
  Light,
  ObjectRenderer,
  PhysicsSystem,
  type Scene,
} from '@farol/engine';
import * as fields from '@farol/engine/fields';
import { deserialize, readSceneFile, serialize, UnknownComponent } from '@farol/engine/files';
import { compileScript, SceneScripts, takeGiven } from '@farol/engine/scripts';
import { root } from '@farol/tools/root';
import * as three from 'three';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { samples } from '../api/Sample';

const readPublic = async (path: string): Promise<Uint8Array<ArrayBuffer>> =>
  new Uint8Array(await readFile(join(root, 'public', path)));

/** Opens a sample as the editor does, and runs its scripts. */
async function open(file: string): Promise<{ scene: Scene; scripts: SceneScripts }> {
  const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const { text, fileOf } = await readSceneFile(await readPublic(`scenes/${file}`));
  const scene = await deserialize(text, { registry, fileOf });
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
  return { scene, scripts };
}

const none = { repeat: false, shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };

/** World matrices of all drawn objects. */
const places = (scene: Scene): number[] => {
  const numbers: number[] = [];
  scene.three.updateMatrixWorld();
  scene.traverse(({ object3D }) => numbers.push(...object3D.matrixWorld.elements.slice(12, 15)));
  return numbers;
};

const files = Object.values(samples).flatMap(({ file }) => file ?? []);

test('every file of a scene is a sample that is shown', async () => {
  expect(await readdir(join(root, 'public/scenes'))).toEqual(files.toSorted());
});

/** Texts of scripts by the file that contains them, from sources that are type-checked. */
const checked = {
  'scripts.json': import.meta.glob<string>('./scripts/*.ts', { eager: true, query: '?raw', import: 'default' }),
  'night-in-the-temple.farol': import.meta.glob<string>('./nightScripts/*.ts', {
    eager: true,
    query: '?raw',
    import: 'default',
  }),
};

test.each(Object.entries(checked))('the scripts of %s are those that are checked', async (file, texts) => {
  const { scene } = await open(file);
  const kept = scene.assets.fieldAssets('script').map((script) => [script.name, script.get('source')]);
  const named = Object.entries(texts).map(([path, text]) => [/(\w+)\.ts$/.exec(path)![1], text]);
  expect(Object.fromEntries(kept)).toEqual(Object.fromEntries(named));
  scene.dispose();
});

describe.each(files)('%s', (file) => {
  let opened: Awaited<ReturnType<typeof open>>;
  beforeAll(async () => void (opened = await open(file)));
  afterAll(() => opened.scene.dispose());

  test('has a camera, shadows, and no component that is not known', () => {
    const { scene, scripts } = opened;
    expect([...scripts.errors.values()].map(({ message }) => message)).toEqual([]);
    const unknown: string[] = [];
    scene.traverse(({ components }) => {
      for (const each of components) if (each instanceof UnknownComponent) unknown.push(each.typeName);
    });
    expect(unknown).toEqual([]);
    expect(scene.activeCamera).not.toBeNull();
    expect(scene.componentsOf(Light).some(({ castShadow }) => castShadow)).toBe(true);
    expect(scene.componentsOf(ObjectRenderer).some(({ receiveShadow }) => receiveShadow)).toBe(true);
  });

  test('moves when it plays, without a fault, and is bit-equal when it is reset', async () => {
    const { scene } = opened;
    const faults: string[] = [];
    scene.onComponentError = (component, error) => void faults.push(`${component.typeName}: ${String(error)}`);
    scene.setTime(0);
    const [before, at] = [JSON.stringify(serialize(scene)), places(scene)];
    for (const type of ['RigidBody', 'Collider'] as const) {
      if (scene.componentsOf(type).length > 0) await scene.system(PhysicsSystem).prepare();
    }
    for (let i = 0; i < 120; i++) scene.update(1 / 60);
    if (file !== 'prefabs.json') expect(places(scene)).not.toEqual(at);
    scene.reset();
    // compared as text: the difference that toEqual prints would be huge
    expect(JSON.stringify(serialize(scene)) === before).toBe(true);
    expect(places(scene)).toEqual(at);
    expect(faults).toEqual([]);
  });
});

test('Night in the temple: one walks up the steps, the door opens, lanterns swing, and crates fall', async () => {
  const { scene } = await open('night-in-the-temple.farol');
  await scene.system(PhysicsSystem).prepare();
  const key = (type: 'down' | 'up', code: string): void => void scene.dispatchKey({ ...none, type, code, key: code });
  const object = (name: string): GameObject => scene.find(name)!;
  const run = (seconds: number): void => {
    for (let i = 0; i < seconds * 60; i++) scene.update(1 / 60);
  };
  const player = object('Player').object3D.position;
  const leaf = object('Left leaf').object3D.rotation;
  const crates = (): string =>
    object('Crates')
      .children.map(({ object3D }) => object3D.position.y.toFixed(2))
      .join();
  run(2);
  const [lantern, pile] = [object('Body').object3D, crates()];
  const hung = lantern.position.x;
  key('down', 'KeyW');
  run(1);
  expect(Math.abs(lantern.position.x - hung)).toBeGreaterThan(0.02);
  expect(leaf.y).toBe(0);
  run(4);
  expect(player.y).toBeGreaterThan(0.9);
  run(4.5);
  expect(leaf.y).toBeCloseTo(1.75, 2);
  expect(player.z).toBeLessThan(4);
  key('up', 'KeyW');
  expect(crates()).toBe(pile);
  // walks beside the pile of crates, then into it
  const walker = object('Player').getComponent(CharacterController)!;
  walker.teleport([5.2, 0, 18]);
  run(0.2);
  walker.walk([0, 0, -1]);
  run(3);
  expect(crates()).not.toBe(pile);
  scene.dispose();
});
