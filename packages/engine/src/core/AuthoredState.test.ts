import { currentOf } from '@farol/editing';
import { expect, test } from 'vitest';
import '../components/index';
import { Camera } from '../components/Camera';
import { Light } from '../components/Light';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { serialize } from '../files/serialize';
import { Component } from './Component';
import { createRandom } from '../base/createRandom';
import { GameObject } from './GameObject';
import { Scene } from './Scene';

const stateOf = (scene: Scene): string => JSON.stringify(serialize(scene));

function makeScene(): Scene {
  const scene = new Scene({ name: 'Start' });
  const house = new GameObject('House');
  const door = new GameObject('Door');
  door.addComponent(ObjectRenderer);
  const lamp = new GameObject('Lamp');
  lamp.addComponent(Light, { type: 'point', intensity: 7 });
  house.add(door).add(lamp);
  const eye = new GameObject('Eye');
  eye.addComponent(Camera);
  scene.add(house).add(eye);
  return scene;
}

/** Makes one random change of a scene, as a script may. */
function disturb(scene: Scene, random: () => number): void {
  const objects: GameObject[] = [];
  scene.traverse((object) => objects.push(object));
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
  if (objects.length === 0) return void scene.add(new GameObject('Only'));
  const object = pick(objects);
  const component = pick(object.components);
  const acts: (() => void)[] = [
    () => object.dispose(),
    () => scene.remove(object),
    () => scene.add(new GameObject('New')),
    () => object.add(new GameObject('Below')),
    () => void (object.name = `Name ${random()}`),
    () => void (object.active = random() < 0.5),
    () => void (object.tags = ['tag']),
    () => void (component.enabled = random() < 0.5),
    () => void object.addComponent(Light),
    () => object.moveComponent(component, 1),
    () => {
      object.removeComponent(component);
      component.dispose();
    },
    () => object.reparent(scene, 0, { keepWorld: false }),
    () => pick(objects).add(object),
    () => void (object.transform.position = [random(), 2, 3]),
    () => void (object.getComponent(Light) ?? object.transform).set('intensity', random()),
    () => void (scene.name = 'Other'),
    () => void scene.assets.addMaterial(`Material ${random()}`),
    () => scene.settings.set('exposure', random()),
    () => void (scene.activeCamera = null),
  ];
  try {
    pick(acts)();
  } catch {
    // invalid changes, such as an object below itself, change nothing
  }
}

test.each([1, 2, 3])('whatever code does after keepAuthored, a reset brings back (seed %i)', (seed) => {
  const random = createRandom(seed);
  const scene = makeScene();
  const before = stateOf(scene);
  const objects = ['House', 'Door', 'Lamp', 'Eye'].map((name) => scene.find(name)!);
  const lights = scene.componentsOf(Light);
  const light = lights[0];
  for (let round = 0; round < 60; round++) {
    scene.keepAuthored();
    scene.update(0.1);
    for (let i = 0; i < 12; i++) disturb(scene, random);
    scene.reset();
    expect(stateOf(scene)).toBe(before);
    expect(objects.map(({ name }) => scene.find(name))).toEqual(objects);
    expect(lights).toEqual([currentOf(light)]);
  }
  // the light is still drawn
  currentOf(light).intensity = 3;
  expect(currentOf(light).three.intensity).toBe(3);
});

test('without keepAuthored what was changed stays', () => {
  const scene = makeScene();
  scene.update(0.1);
  scene.remove(scene.find('Eye')!);
  scene.reset();
  expect(scene.find('Eye')).toBeNull();
});

test('what a component does when it is destroyed is taken back too, and what was removed is disposed of with the scene', () => {
  const scene = makeScene();
  class Last extends Component {
    static override readonly typeName = 'Last';
    disposed = false;
    override onDestroy(): void {
      this.gameObject.name = 'Gone';
      this.gameObject.parent?.dispose();
    }
    override dispose(): void {
      this.disposed = true;
    }
  }
  const last = scene.find('Door')!.addComponent(Last);
  const names = (): string[] => {
    const list: string[] = [];
    scene.traverse(({ name }) => list.push(name));
    return list;
  };
  scene.keepAuthored();
  scene.update(0.1);
  scene.reset();
  expect(names()).toEqual(['House', 'Door', 'Lamp', 'Eye']);
  scene.keepAuthored();
  scene.update(0.1);
  scene.find('House')!.dispose();
  expect(last.disposed).toBe(false);
  scene.dispose();
  expect(last.disposed).toBe(true);
});
