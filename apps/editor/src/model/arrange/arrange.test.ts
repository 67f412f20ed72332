import { GameObject, Light, ObjectRenderer, Scene } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Color } from 'three';
import { describe, expect, it } from 'vitest';
import { EditorDocument } from '../EditorDocument';
import { arrangement } from '../testing/randomArrangement';
import { arrangedPlaces } from './arrangedPlaces';
import { arrangeObjects } from './arrangeObjects';

const positions = (settings: Parameters<typeof arrangement>[0], origins: Vector3Tuple[] = [[1, 2, 3]]): number[][] =>
  arrangedPlaces(arrangement(settings), origins).map(({ position }) =>
    position.map((each) => Math.round(each * 1e6) / 1e6 + 0),
  );

function lamp(parent: Scene | GameObject, name = 'Lamp'): GameObject {
  const object = new GameObject(name);
  object.addComponent(Light, { intensity: 10, range: 5 });
  object.addComponent(ObjectRenderer, { mesh: 'bulb', kind: 'basic' });
  object.transform.position = [1, 2, 3];
  parent.add(object);
  return object;
}

/** A document with a lamp, and a function that arranges it. */
function lampDocument(): { document: EditorDocument; lamps: GameObject; run(settings: object): void } {
  const document = new EditorDocument();
  const scene = new Scene({ assets: document.assets });
  const lamps = lamp(scene);
  document.open(scene);
  const run = (settings: Parameters<typeof arrangement>[0]): void => {
    const chosen = arrangement(settings);
    const places = arrangedPlaces(chosen, [lamps.transform.worldPosition.toArray()]);
    document.commands.run(arrangeObjects(scene, [lamps], places, chosen));
  };
  return { document, lamps, run };
}

describe('arrangedPlaces', () => {
  it('goes on from each original along a line', () => {
    expect(positions({ count: 3, offset: [0, 0, 2] })).toEqual([
      [1, 2, 3],
      [1, 2, 5],
      [1, 2, 7],
    ]);
    expect(
      positions({ count: 2 }, [
        [0, 0, 0],
        [0, 1, 0],
      ]),
    ).toEqual([
      [0, 0, 0],
      [0, 1, 0],
      [1, 0, 0],
      [1, 1, 0],
    ]);
  });

  it('goes round a ring once, or from end to end of an arc', () => {
    expect(positions({ kind: 'ring', count: 4, radius: 2 })).toEqual([
      [3, 2, 3],
      [1, 2, 1],
      [-1, 2, 3],
      [1, 2, 5],
    ]);
    expect(positions({ kind: 'ring', count: 2, radius: 2, arc: Math.PI })).toEqual([
      [3, 2, 3],
      [-1, 2, 3],
    ]);
  });

  it('fills a grid round the original, and no more than the most', () => {
    expect(positions({ kind: 'grid', counts: [2, 2, 1], spacing: [2, 5, 1] })).toEqual([
      [0, 2, 3],
      [2, 2, 3],
      [0, 7, 3],
      [2, 7, 3],
    ]);
    expect(positions({ kind: 'grid', counts: [1000, 1000, 1000] }).length).toBe(20_000);
  });
});

describe('arrangeObjects', () => {
  it('makes 200 lights of all hues in a group, as one step', () => {
    const { document, lamps, run } = lampDocument();
    const before = document.serialize();
    run({ kind: 'ring', count: 200, radius: 8, colours: 'rainbow', intensityVariation: 0.5, grouped: true });
    const [group] = document.scene.roots;
    expect(document.selectedObjects).toEqual([group]);
    expect(group.children.length).toBe(200);
    expect(group.children[0]).toBe(lamps);
    expect(new Set(group.children.map(({ name }) => name)).size).toBe(200);
    expect(group.children.at(-1)!.name).toBe('Lamp 200');
    const lights = document.scene.componentsOf(Light);
    expect(new Set(lights.map(({ diffuse }) => diffuse.join())).size).toBeGreaterThan(150);
    for (const light of lights) {
      expect(light.gameObject.getComponent(ObjectRenderer)!.colour).toEqual(light.diffuse);
      expect(light.gameObject.transform.worldPosition.distanceTo(group.transform.worldPosition)).toBeCloseTo(8, 4);
      expect(Math.abs(light.intensity - 10)).toBeLessThanOrEqual(5);
    }
    const after = document.serialize();
    expect(document.commands.history.length).toBe(1);
    document.commands.undo();
    expect(document.serialize()).toBe(before);
    document.commands.redo();
    expect(document.serialize()).toBe(after);
  });

  it('goes once through all hues, in equal steps, and does not repeat the first', () => {
    const { document, run } = lampDocument();
    run({ kind: 'ring', count: 6, radius: 8, colours: 'rainbow' });
    const hues = document.scene.componentsOf(Light).map(({ diffuse }) => {
      const [r, g, b] = diffuse;
      return Math.round(
        (new Color(r, g, b).multiplyScalar(1 / Math.max(r, g, b)).getHSL({ h: 0, s: 0, l: 0 }).h * 360) / 60,
      );
    });
    expect(hues.toSorted((a, b) => a - b)).toEqual([0, 1, 2, 3, 4, 5]);
  });

  it('gives a copy the same look whatever the count is', () => {
    const looks = [20, 200].map((count) => {
      const { document, run } = lampDocument();
      run({ count, colours: 'random', rangeVariation: 0.4, seed: 7 });
      return document.scene.componentsOf(Light).map(({ diffuse, range }) => [diffuse, range]);
    });
    expect(looks[1].slice(0, 20)).toEqual(looks[0]);
  });

  it('shares the brightness of the original among all where asked, however many they are', () => {
    const total = (count: number, sharesLight: boolean): number => {
      const { document, run } = lampDocument();
      run({ count, sharesLight });
      return document.scene.componentsOf(Light).reduce((sum, { intensity }) => sum + intensity, 0);
    };
    expect([total(4, false), total(4, true), total(40, false)]).toEqual([40, 10, 400]);
    expect(total(40, true)).toBeCloseTo(10, 6);
  });

  it('stays in the parent of the original, after it, and leaves an original that does not move as it is', () => {
    const document = new EditorDocument();
    const scene = new Scene({ assets: document.assets });
    const parent = new GameObject('Parent');
    parent.transform.position = [10, 0, 0];
    parent.transform.rotation = [0, Math.PI / 2, 0];
    parent.transform.scale = [2, 2, 2];
    scene.add(parent);
    const first = lamp(parent);
    first.transform.rotation = [0.1, 0.2, 0.3];
    lamp(parent, 'Other');
    document.open(scene);
    const settings = arrangement({ count: 3, offset: [2, 0, 0] });
    const start = first.transform.worldPosition;
    document.commands.run(arrangeObjects(scene, [first], arrangedPlaces(settings, [start.toArray()]), settings));
    expect(parent.children.map(({ name }) => name)).toEqual(['Lamp', 'Lamp 2', 'Lamp 3', 'Other']);
    expect([...first.transform.position]).toEqual([1, 2, 3]);
    const [, second, third] = parent.children;
    for (const copy of [second, third]) expect([...copy.transform.rotation]).toEqual([0.1, 0.2, 0.3]);
    expect(
      second.transform.worldPosition
        .sub(start)
        .toArray()
        .map((each) => Number(each.toFixed(5))),
    ).toEqual([2, 0, 0]);
    expect(third.transform.worldPosition.sub(start).x).toBeCloseTo(4, 5);
  });
});
