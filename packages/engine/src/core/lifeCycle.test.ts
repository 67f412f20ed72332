import { number } from '@farol/editing/fields';
import { expect, test } from 'vitest';
import '../components/index';
import { Light } from '../components/Light';
import { component, Component } from './Component';
import { serialize } from '../files/serialize';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import { GameObject } from './GameObject';
import { Scene } from './Scene';
import type { SceneSystem } from './SceneSystem';
import { scriptClasses } from './scriptClasses';

const calls: string[] = [];

class Noter extends Component {
  static override readonly typeName = 'Noter';
  override start(): void {
    calls.push('start');
  }
  override update(): void {
    calls.push('update');
  }
  override lateUpdate(): void {
    calls.push('late');
  }
  override onDestroy(): void {
    calls.push('destroy');
  }
}

const systemOf = (order: number) =>
  class implements SceneSystem {
    readonly order = order;
    update(): void {
      calls.push(`system ${order}`);
    }
    reset(): void {
      calls.push(`reset ${order}`);
    }
    dispose(): void {}
  };

test('a component is started once, before its first update that takes time, and destroyed when the scene is reset', () => {
  calls.length = 0;
  const scene = new Scene();
  const object = new GameObject();
  const noter = object.addComponent(Noter);
  scene.add(object);
  const First = systemOf(1);
  expect(scene.system(systemOf(2))).toBeDefined();
  expect(scene.system(First)).toBe(scene.system(First));
  scene.setTime(0);
  expect(calls.splice(0)).toEqual(['update', 'system 1', 'system 2', 'late']);
  expect(scene.isSimulated).toBe(false);
  scene.update(0.1);
  scene.update(0.1);
  const frame = ['update', 'system 1', 'system 2', 'late'];
  expect(calls.splice(0)).toEqual(['start', ...frame, ...frame]);
  scene.reset();
  expect(calls.splice(0)).toEqual(['destroy', 'reset 1', 'reset 2', ...frame]);
  scene.update(0.1);
  expect(calls.splice(0)[0]).toBe('start');
  object.removeComponent(noter);
  expect(calls.splice(0)).toEqual(['destroy']);
});

test('what starts may bring others, which start in the same frame; inactive ones wait', () => {
  const scene = new Scene();
  const object = new GameObject();
  const sleeper = new GameObject();
  sleeper.active = false;
  sleeper.addComponent(Noter);
  class Spawner extends Component {
    static override readonly typeName = 'Spawner';
    override start(): void {
      const child = new GameObject();
      child.addComponent(Noter);
      scene.add(child);
    }
  }
  object.addComponent(Spawner);
  scene.add(object).add(sleeper);
  calls.length = 0;
  scene.update(0.1);
  expect(calls).toEqual(['start', 'update', 'late']);
  sleeper.active = true;
  scene.update(0.1);
  expect(calls.filter((call) => call === 'start')).toHaveLength(2);
});

test('a component that goes to another scene, or whose script threw, is called by the first scene no more', () => {
  class Hearer extends Component {
    static override readonly typeName = 'Hearer';
    override update = (): number => calls.push('update');
    override lateUpdate = (): number => calls.push('late');
    override onKeyDown = (): number => calls.push('key down');
    override onPointerMove = (): number => calls.push('move');
    override onPointerOver = (): number => calls.push('over');
  }
  const all = ['update', 'late', 'key down', 'move'];
  const callsOf = (scene: Scene): string[] => {
    calls.length = 0;
    scene.update(0.1);
    scene.dispatchKey({ type: 'down', code: 'KeyE', key: 'e', repeat: false } as EngineKeyEvent);
    scene.dispatchPointer({ type: 'move' } as EnginePointerEvent);
    return calls.splice(0);
  };
  const [first, second] = [new Scene(), new Scene()];
  const object = new GameObject();
  const hearer = object.addComponent(Hearer);
  first.add(object);
  expect(callsOf(first)).toEqual(all);
  first.remove(object);
  second.add(object);
  expect(callsOf(first)).toEqual([]);
  expect([first.takesKeys, second.takesKeys]).toEqual([false, true]);
  expect(callsOf(second)).toEqual(all);
  scriptClasses.add(Hearer);
  second.onComponentError = () => {};
  second.reportError(hearer, new Error('broken'));
  expect(callsOf(second)).toEqual([]);
  expect(second.takesKeys).toBe(false);
});

test('a field cannot have the name of a method that the engine calls', () => {
  for (const name of ['start', 'lateUpdate', 'onPointerClick', 'onCollisionEnter'])
    expect(() => component({ [name]: number(1, { help: 'x' }) })).toThrow(`The field '${name}'`);
  expect(() => component({ startTime: number(1, { help: 'x' }), one: number(1, { help: 'x' }) })).not.toThrow();
});

test('a simulated value is shown and drawn, and neither saved nor told; a reset takes it back', () => {
  const scene = new Scene();
  const object = new GameObject();
  const light = object.addComponent(Light, { intensity: 2 });
  scene.add(object);
  const before = JSON.stringify(serialize(scene));
  const { revision } = scene;
  light.simulate('intensity', 5);
  object.transform.simulate('position', [1, 2, 3]);
  expect([light.intensity, light.three.intensity, object.object3D.position.y]).toEqual([5, 5, 2]);
  expect(light.getAuthored('intensity')).toBe(2);
  expect(JSON.stringify(serialize(scene))).toBe(before);
  expect(scene.revision).toBe(revision);
  scene.reset();
  expect([light.intensity, light.three.intensity, object.object3D.position.y]).toEqual([2, 2, 0]);
  light.simulate('intensity', 5);
  light.set('intensity', 3);
  expect([light.intensity, light.three.intensity]).toEqual([3, 3]);
  expect(() => light.simulate('intensity', Number.NaN)).toThrow(/intensity/);
});
