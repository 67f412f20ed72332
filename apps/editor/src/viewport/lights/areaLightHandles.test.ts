import { GameObject, Light, Scene } from '@farol/engine';
import { Ray, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { areaLightHandles } from './areaLightHandles';

function lamp(values: Parameters<GameObject['addComponent']>[1]): Light {
  const object = new GameObject('Lamp');
  object.transform.position = [1, 2, 3];
  new Scene().add(object);
  return object.addComponent(Light, values);
}

const down = new Vector3(0, 0, -1);

/** Drags a handle of a light to a point in the light's plane. @returns the text beside the pointer */
function drag(light: Light, handle: number, x: number, y: number, step = 0.01): string {
  const { drag, textOf } = areaLightHandles(light)[handle];
  const command = drag(new Ray(new Vector3(x, y, 10), down), step, down)!;
  command.do();
  return textOf!(command.edits);
}

describe('the handles of a light with a shape', () => {
  it('are on its edges, whatever the size of its object', () => {
    const light = lamp({ type: 'rectangle', width: 2, height: 0.5 });
    light.gameObject.transform.scale = [3, 3, 3];
    expect(areaLightHandles(light).map(({ place }) => place.toArray())).toEqual([
      [2, 2, 3],
      [0, 2, 3],
      [1, 2.25, 3],
      [1, 1.75, 3],
    ]);
  });

  it('size a rectangle along one side, from its middle', () => {
    const light = lamp({ type: 'rectangle', width: 2, height: 0.5 });
    expect(drag(light, 0, 2.5, 2)).toBe('Width 3 m');
    expect([light.width, light.height]).toEqual([3, 0.5]);
    expect(drag(light, 3, 1, 1.38)).toBe('Height 1.24 m');
    expect([light.width, light.height]).toEqual([3, 1.24]);
    drag(light, 1, 0.3, 2, 0.5);
    expect(light.width).toBe(1.5);
  });

  it('keep a round disc round, and let an ellipse grow along one axis', () => {
    const light = lamp({ type: 'disc', width: 1, height: 1 });
    expect(drag(light, 2, 1, 2.75)).toBe('Radius 0.75 m');
    expect([light.width, light.height]).toEqual([1.5, 1.5]);
    light.height = 1;
    expect(drag(light, 0, 2, 2)).toBe('Width 2 m');
    expect([light.width, light.height]).toEqual([2, 1]);
  });

  it('give a tube its length and thickness, and no less than a centimetre', () => {
    const light = lamp({ type: 'tube', width: 1, height: 0.05 });
    expect(drag(light, 1, -0.2, 2)).toBe('Length 2.4 m');
    expect(drag(light, 2, 1, 1)).toBe('Thickness 0.01 m');
    expect([light.width, light.height]).toEqual([2.4, 0.01]);
  });

  it('are none of other lights', () => {
    expect(areaLightHandles(lamp({ type: 'point' }))).toEqual([]);
  });
});
