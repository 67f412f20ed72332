import { Camera, Group, LightProbe, Mesh, Object3D, PointLight, RectAreaLight, Scene, SpotLight, Sprite } from 'three';
import { describe, expect, it } from 'vitest';
import { POINT } from '../lights/plainPoints';
import { FoundLights } from '../lights/FoundLights';
import { collectLights } from './collectLights';

const nothingLeft = { shadows: false, cookies: false, areas: false, all: false };

function collect(root: Object3D): FoundLights {
  const found = new FoundLights();
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
        named(new LightProbe(), 'probe'),
        hidden,
        unseen,
        otherLayer,
      ),
    );
    expect(names(all)).toEqual(['plain', 'carrier', 'in group']);
    expect(names(nested)).toEqual(['carrier']);
    expect(names(rest)).toEqual(['carrier', 'probe']);
  });

  it('leaves three no object that only holds lights, however deep, and none of its lights', () => {
    class Own extends Group {}
    const sprite = named(new Sprite(), 'sprite');
    sprite.visible = false;
    const { all, nested, rest } = collect(
      new Scene().add(
        named(
          new Object3D(),
          'lamp',
          named(new Group(), 'arm', named(new SpotLight(), 'spot', new Object3D()), sprite),
        ),
        named(new Group(), 'lamp with a shape', named(new PointLight(), 'bulb'), named(new Mesh(), 'shade')),
        named(new Group(), 'lamp with a probe', named(new PointLight(), 'beside'), new LightProbe()),
        named(new Own(), "host's", named(new PointLight(), 'own')),
        named(new Group(), 'empty'),
        named(new PointLight(), 'double', named(new PointLight(), 'second')),
      ),
    );
    expect(names(all)).toEqual(['spot', 'bulb', 'beside', 'own', 'double', 'second']);
    expect(names(nested)).toEqual(['bulb', 'beside', 'own']);
    expect(names(rest)).toEqual(['lamp with a shape', 'lamp with a probe', "host's", 'empty']);
  });

  it('leaves area lights to three until their code is there, and says that there are some', () => {
    const scene = new Scene().add(named(new RectAreaLight(), 'rectangle'));
    expect(names(collect(scene).all)).toEqual(['rectangle']);
    const found = new FoundLights();
    collectLights(scene, new Camera(), { ...nothingLeft, areas: true }, found);
    expect([names(found.all), names(found.rest), found.hasArea]).toEqual([[], ['rectangle'], true]);
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

  it('brings world matrices up to date as three does, whatever moves, hides, or keeps its own matrix', () => {
    let seed = 7;
    const next = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;
    const choose = <T>(...of: T[]): T => of[Math.floor(next() * of.length)];
    class Own extends PointLight {
      calls = 0;
      override updateMatrixWorld(force?: boolean): void {
        this.calls++;
        super.updateMatrixWorld(force);
      }
    }
    const grow = (parent: Object3D, depth: number): void => {
      for (let i = 0; i < 8; i++) {
        const child = choose<() => Object3D>(
          () => new PointLight(),
          () => new PointLight(),
          () => new Group(),
          () => new Mesh(),
          () => new Own(),
        )();
        child.visible = next() > 0.2;
        child.matrixAutoUpdate = next() > 0.2;
        child.matrixWorldAutoUpdate = next() > 0.2;
        parent.add(child);
        if (depth > 0 && next() < 0.4) grow(child, depth - 1);
      }
    };
    const move = (object: Object3D): void => {
      object.traverse((each) => {
        if (next() < 0.5) each.position.set(next(), next(), next());
        if (next() < 0.3) each.rotation.set(next(), next(), next());
        if (next() < 0.1) each.matrixWorldNeedsUpdate = true;
      });
    };
    for (let round = 0; round < 8; round++) {
      const root = round % 4 === 3 ? new Group() : new Scene();
      root.visible = round % 4 !== 2;
      grow(root, 2);
      const twin = root.clone();
      for (let frame = 0; frame < 4; frame++) {
        const before = seed;
        if (round > 3) move(root);
        else for (const child of root.children) move(child);
        seed = before;
        if (round > 3) move(twin);
        else for (const child of twin.children) move(child);
        const found = new FoundLights();
        collectLights(root, new Camera(), nothingLeft, found, true);
        twin.updateMatrixWorld();
        const expected: Object3D[] = [];
        twin.traverse((each) => expected.push(each));
        let i = 0;
        root.traverse((each) => {
          const wanted = expected[i++];
          expect(each.matrixWorld.elements).toEqual(wanted.matrixWorld.elements);
          expect(each.matrix.elements).toEqual(wanted.matrix.elements);
          expect(each.matrixWorldNeedsUpdate).toBe(wanted.matrixWorldNeedsUpdate);
          if (each instanceof Own) expect(each.calls).toBe((wanted as Own).calls);
        });
        expect(names(found.all)).toEqual(names(collect(root).all));
        found.all.forEach(({ matrixWorld: { elements } }, n) =>
          expect([...found.points.slice(n * POINT, n * POINT + 3)]).toEqual(elements.slice(12, 15)),
        );
      }
    }
  });

  it('counts the lights of each frame anew', () => {
    const root = new Scene().add(new PointLight(), new RectAreaLight());
    const byThree = { ...nothingLeft, all: true, areas: true };
    const found = new FoundLights();
    for (let frame = 0; frame < 2; frame++) {
      collectLights(root, new Camera(), byThree, found);
      expect({ count: found.count, left: found.left, hasArea: found.hasArea }).toEqual({
        count: 0,
        left: 2,
        hasArea: true,
      });
    }
    collectLights(new Scene(), new Camera(), byThree, found);
    expect({ left: found.left, hasArea: found.hasArea }).toEqual({ left: 0, hasArea: false });
  });
});
