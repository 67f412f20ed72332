import { FieldError, object } from '@farol/editing/fields';
import { Matrix4 } from 'three';
import { describe, expect, test, vi } from 'vitest';
import { Camera } from '../components/Camera';
import { builtinComponents } from '../components/index';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { Light } from '../components/Light';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { Transform } from '../core/Transform';
import { component, Component } from './Component';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { createRandom } from '../base/createRandom';
import { GameObject } from './GameObject';
import { gameObjectOf } from './gameObjectOf';
import { Scene } from './Scene';
import type { SceneChange } from './SceneChange';

class Listener extends Component {
  static override readonly typeName: string = 'Listener';
  readonly calls: unknown[][] = [];
  hear(...args: unknown[]): void {
    this.calls.push(args);
  }
}

/** a > (b > c, d) */
function family(): Record<'a' | 'b' | 'c' | 'd', GameObject> {
  const [a, b, c, d] = ['a', 'b', 'c', 'd'].map((name) => new GameObject(name));
  a.add(b).add(d);
  b.add(c);
  return { a, b, c, d };
}

function place(gameObject: GameObject, seed: number): void {
  const random = createRandom(seed);
  gameObject.transform.position = [random() * 10, random() * 10, random() * 10];
  gameObject.transform.rotation = [random() * 2, random() * 2, random() * 2];
  const scale = 0.5 + random();
  gameObject.transform.scale = [scale, scale, scale];
}

const expectSameMatrix = (a: Matrix4, b: Matrix4): void =>
  a.elements.forEach((element, i) => expect(element).toBeCloseTo(b.elements[i], 9));

describe('callMethod', () => {
  test('reaches every component that has the method, in all children, with its arguments', () => {
    const { a, b, c, d } = family();
    d.active = false;
    const listeners = [a, c, c, d].map((each) => each.addComponent(Listener));
    listeners[3].enabled = false;
    expect(a.callMethod('hear', 1, 'two')).toBe(4);
    expect(b.callMethod('hear', 3)).toBe(2);
    expect(listeners.map(({ calls }) => calls.length)).toEqual([1, 2, 2, 1]);
    expect(listeners[0].calls[0]).toEqual([1, 'two']);
    expect(a.callMethod('nobodyHasThis')).toBe(0);
  });

  test('of a scene reaches all roots; what every object has is refused', () => {
    const scene = new Scene();
    const roots = [new GameObject('x'), new GameObject('y')];
    for (const root of roots) {
      root.addComponent(Listener);
      scene.add(root);
    }
    expect(scene.callMethod('hear')).toBe(2);
    expect(() => roots[0].callMethod('constructor')).toThrow(/'constructor'/);
  });

  test('survives components that take objects away while it runs', () => {
    const { a, b, c, d } = family();
    const remove = new Listener();
    remove.hear = () => a.remove(d);
    b.addComponent(remove);
    const last = [c, d].map((each) => each.addComponent(Listener));
    expect(a.callMethod('hear')).toBe(3);
    expect(last[1].calls).toHaveLength(1);
    expect(a.children).toEqual([b]);
  });
});

describe('the tree', () => {
  test('refuses cycles and stays as it was', () => {
    const { a, b, c } = family();
    expect(() => c.add(a)).toThrow(/'a' cannot be put below itself/);
    expect(() => a.add(a)).toThrow(/below itself/);
    expect(() => b.reparent(c)).toThrow(/below itself/);
    expect(a.children.map(({ name }) => name)).toEqual(['b', 'd']);
    expect(c.parent).toBe(b);
  });

  test('keeps the order that index asks for, in a move among siblings too', () => {
    const { a, b, d } = family();
    const e = new GameObject('e');
    a.add(e, 1);
    expect(a.children).toEqual([b, e, d]);
    a.add(e, 0);
    expect(a.children).toEqual([e, b, d]);
    a.add(e, 99);
    expect(a.children).toEqual([b, d, e]);
  });

  test('a re-parented object stays where it is in the world; add keeps its local transform', () => {
    const { a, b, c, d } = family();
    [a, b, c, d].forEach((each, i) => place(each, i + 1));
    const scene = new Scene();
    scene.add(a);
    const before = c.transform.modelMatrix;
    c.reparent(d);
    expect(c.parent).toBe(d);
    expectSameMatrix(c.transform.modelMatrix, before);
    c.reparent(scene, 0);
    expect(scene.roots).toEqual([c, a]);
    expectSameMatrix(c.transform.modelMatrix, before);
    const local = c.transform.position;
    d.add(c);
    expect(c.transform.position).toEqual(local);
  });

  test('hangs the three objects the same way, and finds GameObjects from them', () => {
    const { a, b, c } = family();
    const scene = new Scene();
    scene.add(a);
    expect(c.object3D.parent).toBe(b.object3D);
    expect(a.object3D.parent).toBe(scene.three);
    const mesh = c.addComponent(ObjectRenderer).three!;
    expect(gameObjectOf(mesh)).toBe(c);
    expect(gameObjectOf(scene.three)).toBeNull();
  });

  test('a parent that is not active stops its children', () => {
    const { a, b, c } = family();
    const light = c.addComponent(Light);
    expect(light.isActive).toBe(true);
    a.active = false;
    expect(light.isActive).toBe(false);
    const outside = new GameObject('outside');
    outside.add(c);
    expect(light.isActive).toBe(true);
    b.add(c);
    expect(light.isActive).toBe(false);
    a.active = true;
    light.enabled = false;
    expect(light.isActive).toBe(false);
    expect(light.three.visible).toBe(false);
  });
});

describe('components', () => {
  test('a unique type cannot be there twice, and the Transform cannot go', () => {
    const gameObject = new GameObject('one');
    gameObject.addComponent('Light');
    expect(() => gameObject.addComponent(Light)).toThrow(/'one' has a Light already/);
    expect(() => gameObject.addComponent(Transform)).toThrow(/Transform already/);
    expect(() => gameObject.removeComponent(gameObject.transform)).toThrow(/cannot be removed/);
    expect(() => gameObject.addComponent('Laser')).toThrow(/Unknown component 'Laser'; known: Transform/);
  });

  test('a wrong value is refused by name and changes nothing', () => {
    const light = new GameObject('lamp').addComponent(Light);
    expect(() => light.set('intensity', NaN)).toThrow(FieldError);
    expect(() => light.set('intensity', NaN)).toThrow(
      'Light.intensity must be a finite number of at least 0 cd or lx or nt, not NaN',
    );
    expect(() => light.set('glow', 1)).toThrow(/Light\.glow is unknown; the fields are type/);
    expect(light.intensity).toBe(1);
    expect(() => new GameObject('x').addComponent(Light, { intensity: -1 })).toThrow(FieldError);
  });

  test('values cannot be changed from outside', () => {
    const { transform } = new GameObject('lamp');
    const given: [number, number, number] = [1, 2, 3];
    transform.position = given;
    given[0] = 9;
    expect(transform.position).toEqual([1, 2, 3]);
    expect(() => ((transform.getAuthored('position') as unknown as number[])[0] = 9)).toThrow(TypeError);
  });

  test('an asset that nobody knows is refused, on entry to a scene and in it', () => {
    const scene = new Scene();
    const statue = new GameObject('statue');
    const renderer = statue.addComponent(ObjectRenderer, { mesh: 'teapot' });
    expect(() => scene.add(statue)).toThrow(/ObjectRenderer\.mesh names the mesh 'teapot', which is unknown/);
    expect(statue.scene).toBeNull();
    expect(scene.roots).toEqual([]);
    renderer.mesh = 'torus';
    scene.add(statue);
    expect(() => (renderer.map = 'nowhere')).toThrow(/ObjectRenderer\.map names the texture 'nowhere'/);
    expect(renderer.map).toBeNull();
  });

  test('without an object it says so by name', () => {
    expect(() => new Light().gameObject).toThrow(/This Light is on no GameObject/);
  });
});

describe('a scene', () => {
  test('holds fast lists of lights and cameras as objects come and go', () => {
    const scene = new Scene();
    const { a, c, d } = family();
    const lights = [c, d].map((each) => each.addComponent(Light));
    a.addComponent('Camera');
    scene.add(a);
    expect(new Set(scene.componentsOf(Light))).toEqual(new Set(lights));
    expect(scene.activeCamera).toBe(scene.componentsOf(Camera)[0]);
    scene.remove(c);
    expect(scene.componentsOf(Light)).toEqual([lights[1]]);
    expect(scene.findById(c.id)).toBeNull();
    d.removeComponent(lights[1]);
    scene.remove(a);
    expect(scene.componentsOf(Light)).toEqual([]);
    expect(scene.activeCamera).toBeNull();
    expect(scene.three.children).toEqual([]);
  });

  test('refuses a second object of the same id', () => {
    const scene = new Scene();
    scene.add(new GameObject('a', { id: 'same' }));
    expect(() => scene.add(new GameObject('b', { id: 'same' }))).toThrow(/id 'same'/);
    expect(scene.roots).toHaveLength(1);
  });

  test('tells of edits, and of each one once; not of values that stay the same', () => {
    const scene = new Scene();
    const { a, b } = family();
    scene.add(a);
    const changes: SceneChange[] = [];
    const stop = scene.onChange((change) => changes.push(change));
    const from = scene.revision;
    const light = b.addComponent(Light);
    light.intensity = 4;
    light.intensity = 4;
    b.name = 'new';
    scene.settings.fog = 'linear';
    b.reparent(scene);
    scene.remove(b);
    expect(changes.map(({ kind }) => kind)).toEqual(['component-add', 'field', 'object', 'settings', 'move', 'remove']);
    expect(scene.revision - from).toBe(6);
    stop();
    a.name = 'unheard';
    expect(changes).toHaveLength(6);
  });

  test('updates active components that override update, and no others', () => {
    const scene = new Scene();
    const { a, b, c } = family();
    class Ticker extends Component {
      static override readonly typeName: string = 'Ticker';
      readonly ticks: number[] = [];
      override update(delta: number, time: number): void {
        this.ticks.push(delta, time);
      }
    }
    const [ticker, hidden, off] = [a, b, c].map((each) => each.addComponent(Ticker));
    const idle = a.addComponent(Listener);
    const spy = vi.spyOn(Component.prototype, 'update');
    b.active = false;
    off.enabled = false;
    scene.add(a);
    scene.update(0.5);
    scene.update(0.25);
    scene.setTime(9);
    expect(ticker.ticks).toEqual([0.5, 0.5, 0.25, 0.75, 0, 9]);
    expect(hidden.ticks).toEqual([]);
    expect(spy).not.toHaveBeenCalled();
    expect(idle.calls).toEqual([]);
    spy.mockRestore();
  });
});

class Follower extends component({ target: object(null, { help: 'Whom it follows.' }) }) {
  static override readonly typeName: string = 'Follower';
}

test('references inside a clone follow it; those out of it stay', () => {
  const { a, b, c } = family();
  const outside = new GameObject('outside');
  b.addComponent(Follower, { target: c.id });
  c.addComponent(Follower, { target: outside.id });
  const copy = a.clone();
  const [b2] = copy.children;
  expect(b2.getComponent(Follower)!.target).toBe(b2.children[0].id);
  expect(b2.children[0].getComponent(Follower)!.target).toBe(outside.id);
});

test('a reference to an object that is gone is saved as none, so that the file loads', async () => {
  const registry = new ComponentRegistry([...builtinComponents.types.values(), Follower]);
  const scene = new Scene({ registry });
  const { a, b, c } = family();
  scene.add(a);
  b.addComponent('Follower', { target: c.id });
  a.addComponent('Follower', { target: b.id });
  scene.remove(c);
  const copy = await deserialize(serialize(scene), { registry });
  expect(copy.find('b')!.getComponent('Follower')!.get('target')).toBeNull();
  expect(copy.find('a')!.getComponent('Follower')!.get('target')).toBe(b.id);
});

test('a component that was taken off comes back as it was, with its id and at its place', () => {
  const { a } = family();
  new Scene().add(a);
  const [light, camera] = [a.addComponent('Light', { intensity: 3 }), a.addComponent('Camera')];
  const { id } = light;
  a.removeComponent(light);
  expect(a.scene!.componentsOf(Light)).toEqual([]);
  a.addComponent(light, {}, { index: 1 });
  expect(a.components).toEqual([a.transform, light, camera]);
  expect(light.id).toBe(id);
  expect(a.scene!.findComponentById(id)).toBe(light);
  expect(light.get('intensity')).toBe(3);
  a.moveComponent(light, 5);
  expect(a.components).toEqual([a.transform, camera, light]);
});

test('a clone has new ids and the same content, down to the last child', () => {
  const { a, c } = family();
  place(c, 3);
  c.tags = ['x'];
  c.addComponent(Light, { intensity: 7 }, { enabled: false });
  const copy = a.clone();
  const again = copy.children[0].children[0];
  expect(again.transform.authoredValues()).toEqual(c.transform.authoredValues());
  expect(again.getComponent(Light)!.intensity).toBe(7);
  expect(again.getComponent(Light)!.enabled).toBe(false);
  expect(again.tags).toEqual(['x']);
  const ids = new Set<string>();
  for (const root of [a, copy]) root.traverse(({ id }) => ids.add(id));
  expect(ids.size).toBe(8);
  const scene = new Scene();
  scene.add(a).add(copy);
  expect(scene.componentsOf(Light)).toHaveLength(2);
});
