import { isFieldVisible } from '@farol/editing/fields';
import { describe, expect, test } from 'vitest';
import { Camera } from '../components/Camera';
import { builtinComponents } from '../components/index';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { sceneFields } from '../settings/SceneSettings';
import { randomFieldValue } from '../fields/randomFieldValue';
import { deserialize } from './deserialize';
import { serialize } from './serialize';

const assetNames = {
  mesh: ['box', 'sphere', 'torus'],
  texture: ['checker'],
  material: [],
  shader: [],
  model: [],
  script: [],
  clip: [],
  sound: [],
  profile: ['profile/downlight'],
  surface: [],
  bake: [],
};

describe.each([...builtinComponents.types.keys()])('%s', (typeName) => {
  test.each([1, 2, 3])('keeps random values of every field through a file (seed %i)', async (seed) => {
    const random = createRandom(seed);
    const scene = new Scene({ name: 'Round trip' });
    const gameObject = new GameObject('Bearer');
    scene.add(gameObject);
    const component = typeName === 'Transform' ? gameObject.transform : gameObject.addComponent(typeName);
    for (const [name, field] of Object.entries(component.fields)) {
      const names = field.kind === 'asset' ? assetNames[field.assetType] : [];
      component.set(name, randomFieldValue(field, random, names));
    }
    component.enabled = false;
    const text = JSON.stringify(serialize(scene));
    const copy = await deserialize(text);
    const again = copy.find('Bearer')!.getComponent(typeName)!;
    expect(again.authoredValues()).toEqual(component.authoredValues());
    expect(again.enabled).toBe(false);
    expect(JSON.stringify(serialize(copy))).toBe(text);
    scene.dispose();
    copy.dispose();
  });

  test('declares help for every field, defaults that it allows, and conditions on fields that it has', () => {
    const type = builtinComponents.types.get(typeName)!;
    const component = new type();
    expect(type.help).not.toBe('');
    for (const [name, field] of Object.entries(type.fields)) {
      expect(field.help, name).toMatch(/[.!]$/);
      expect(() => component.set(name, field.default), name).not.toThrow();
      if (field.visibleWhen) expect(type.fields, name).toHaveProperty(field.visibleWhen.field);
      expect(typeof isFieldVisible(type.fields, name, (other) => component.get(other))).toBe('boolean');
    }
  });
});

test('settings, hierarchy, order, tags, activity and the camera survive a file', async () => {
  const random = createRandom(9);
  const scene = new Scene({ name: 'All sorts' });
  for (const [name, field] of Object.entries(sceneFields)) {
    const names = field.kind === 'asset' ? assetNames[field.assetType] : [];
    scene.settings.set(name, randomFieldValue(field, random, names));
  }
  const parent = new GameObject('Parent');
  scene.add(parent);
  for (const name of ['c', 'a', 'b']) parent.add(new GameObject(name));
  parent.children[1].active = false;
  parent.children[1].locked = true;
  parent.children[0].isStatic = true;
  parent.children[2].tags = ['lamp', 'far'];
  for (const name of ['First', 'Second']) {
    const camera = new GameObject(name);
    camera.addComponent('Camera');
    scene.add(camera);
  }
  scene.activeCamera = scene.componentsOf(Camera)[1];
  scene.microShaders.set('own/tint', 'vec3 tint;\n');
  scene.microShaders.set('heatMap', '#include "own/tint"\n// "quoted"\n');
  const view = { name: 'Door', position: [1, 2, 3], target: [0, 0, 0.5], fov: 1, orthographic: true } as const;
  scene.picture = { url: 'data:image/webp;base64,UklGRg==', chosen: true };
  scene.views.set(7, view);
  scene.views.set(2, { ...view, name: '' });
  const copy = await deserialize(JSON.parse(JSON.stringify(serialize(scene))));
  expect(serialize(copy)).toEqual(serialize(scene));
  expect(copy.views.entries.map(([place]) => place)).toEqual([2, 7]);
  expect(copy.views.get(7)).toEqual(view);
  expect(copy.picture).toEqual(scene.picture);
  expect(Object.keys(serialize(copy).microShaders!)).toEqual(['heatMap', 'own/tint']);
  expect(copy.microShaders.get('own/tint')).toBe('vec3 tint;\n');
  expect(copy.roots[0].children.map((child) => child.name)).toEqual(['c', 'a', 'b']);
  expect(copy.activeCamera?.gameObject.name).toBe('Second');
  expect(copy.find('a')!.activeInHierarchy).toBe(false);
});

test('simulation is not saved', async () => {
  const scene = new Scene();
  const lamp = new GameObject('Lamp');
  lamp.transform.position = [1, 2, 3];
  lamp.addComponent('RandomMovement');
  scene.add(lamp);
  const before = serialize(scene);
  const { revision } = scene;
  scene.update(1.5);
  expect(lamp.transform.position).not.toEqual([1, 2, 3]);
  expect(serialize(scene)).toEqual(before);
  expect(scene.revision).toBe(revision);
  scene.reset();
  expect(lamp.transform.position).toEqual([1, 2, 3]);
});
