import { Camera, Group, Mesh, Object3D, PointLight, RectAreaLight, Scene } from 'three';
import { describe, expect, it } from 'vitest';
import { collectLights, type FoundLights } from './collectLights';

const nothingLeft = { shadows: false, cookies: false };

function collect(root: Object3D): FoundLights {
  const found: FoundLights = { all: [], count: 0, nested: [], rest: [], seeksMasks: true, masks: 0 };
  collectLights(root, new Camera(), nothingLeft, found);
  return found;
}

const named = <T extends Object3D>(object: T, name: string, ...children: Object3D[]): T => {
  object.name = name;
  if (children.length > 0) object.add(...children);
  return object;
};
const names = (objects: readonly Object3D[]): string[] => objects.map(({ name }) => name);

describe('collectLights', () => {
  it('takes the managed lights of a scene, and leaves three what is not one of them or has children', () => {
    const hidden = named(new Group(), 'hidden', named(new PointLight(), 'in hidden'));
    const unseen = named(new PointLight(), 'unseen');
    const otherLayer = named(new PointLight(), 'other layer');
    hidden.visible = unseen.visible = false;
    otherLayer.layers.set(3);
    const { all, nested, rest } = collect(
      new Scene().add(
        named(new PointLight(), 'plain'),
        named(new PointLight(), 'carrier', named(new Mesh(), 'carried')),
        named(new Group(), 'group', named(new PointLight(), 'in group')),
        named(new RectAreaLight(), 'rectangle'),
        hidden,
        unseen,
        otherLayer,
      ),
    );
    expect(names(all)).toEqual(['plain', 'carrier', 'in group']);
    expect(names(nested)).toEqual(['carrier', 'in group']);
    expect(names(rest)).toEqual(['carrier', 'group', 'rectangle', 'hidden', 'other layer']);
  });

  it('gives three a root that is no scene as it is, its lights nested', () => {
    const { nested, rest } = collect(named(new Group(), 'root', named(new PointLight(), 'child')));
    expect([names(nested), names(rest)]).toEqual([['child'], ['root']]);
  });

  it('counts the lights that may be masked, and lets go of those of an earlier frame', () => {
    const scene = new Scene().add(new PointLight(), new PointLight());
    (scene.children[0] as PointLight).castShadow = true;
    const found = collect(scene);
    expect([found.masks, found.all.length]).toEqual([1, 2]);
    scene.clear();
    collectLights(scene, new Camera(), nothingLeft, found);
    expect([found.masks, found.all.length, found.rest.length]).toEqual([0, 0, 0]);
  });
});
