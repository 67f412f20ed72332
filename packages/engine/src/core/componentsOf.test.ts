import { describe, expect, test } from 'vitest';
import { Camera } from '../components/Camera';
import { Light } from '../components/Light';
import { Transform } from '../core/Transform';
import { createRandom } from '../base/createRandom';
import { GameObject } from './GameObject';
import { Scene } from './Scene';

class Lamp extends Light {
  static override readonly typeName: string = 'Lamp';
}

const lit = (type: typeof Light = Light): GameObject => {
  const object = new GameObject();
  object.addComponent(type);
  return object;
};

describe('componentsOf', () => {
  test('is the same array all along, whenever it is asked for first', () => {
    const scene = new Scene();
    const early = scene.componentsOf(Light);
    const [a, b] = [lit(), lit()];
    scene.add(a).add(b);
    expect(new Set(early)).toEqual(new Set([a.getComponent(Light), b.getComponent(Light)]));
    const late = scene.componentsOf(Transform);
    expect(new Set(late)).toEqual(new Set([a.transform, b.transform]));
    a.removeComponent(a.getComponent(Light)!);
    scene.remove(b);
    expect(scene.componentsOf(Light)).toBe(early);
    expect(scene.componentsOf(Transform)).toBe(late);
    expect(early).toEqual([]);
    expect(late).toEqual([a.transform]);
  });

  test('holds derived classes; by name only those of that name', () => {
    const scene = new Scene();
    const [light, lamp] = [lit(), lit(Lamp)].map((object) => object.components[1]);
    scene.add(light.gameObject).add(lamp.gameObject);
    expect(new Set(scene.componentsOf(Light))).toEqual(new Set([light, lamp]));
    expect(scene.componentsOf(Lamp)).toEqual([lamp]);
    expect(scene.componentsOf('Light')).toEqual([light]);
    expect(scene.componentsOf('Lamp')).toEqual([lamp]);
    expect(scene.componentsOf('Nothing')).toEqual([]);
  });

  test('holds, after any edits, what a walk of the tree finds', () => {
    const random = createRandom(5);
    const below = (n: number): number => Math.floor(random() * n);
    const scene = new Scene();
    const all = [...Array(40).keys()].map(() => new GameObject());
    scene.componentsOf(Light);
    for (let step = 0; step < 600; step++) {
      const object = all[below(all.length)];
      const other = all[below(all.length)];
      const light = object.getComponent(Light);
      const kind = below(5);
      if (kind === 0 && !light) object.addComponent(random() < 0.5 ? Light : Lamp);
      else if (kind === 1 && light) object.removeComponent(light);
      else if (kind === 2 && object !== other && !object.find(other.id)) other.add(object);
      else if (kind === 3) scene.add(object);
      else if (kind === 4 && object.scene) scene.remove(object);
      if (step === 300) scene.componentsOf(Camera);
      const walked = new Set<unknown>();
      scene.traverse((each) => each.getComponents(Light).forEach((found) => walked.add(found)));
      expect(new Set(scene.componentsOf(Light))).toEqual(walked);
    }
    expect(scene.componentsOf(Light).length).toBeGreaterThan(3);
  });
});
