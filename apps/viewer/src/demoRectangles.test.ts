import { GameObject, Light, Scene } from '@farol/engine';
import { BoxGeometry, Mesh } from 'three';
import { describe, expect, it } from 'vitest';
import { setDemoRectangles } from './demoRectangles';

function room(): Scene {
  const scene = new Scene();
  scene.add(new GameObject('Box'));
  scene.three.add(new Mesh(new BoxGeometry(10, 4, 6)));
  return scene;
}

describe('rectangle lights put into a scene', () => {
  it('are as many as asked for, within what is there, and end', () => {
    const scene = room();
    setDemoRectangles(scene, 30);
    const lights = scene.componentsOf(Light);
    expect(lights).toHaveLength(30);
    for (const { type, position, direction, reach } of lights) {
      expect(type).toBe('rectangle');
      expect(reach).toBe(1.5);
      expect(direction.y).toBeLessThan(-0.5);
      expect(Math.abs(position.x)).toBeLessThanOrEqual(4);
      expect(Math.abs(position.y)).toBeLessThan(2);
      expect(Math.abs(position.z)).toBeLessThanOrEqual(2.4);
    }
  });

  it('are the same in every run, stay while their number stays, and go', () => {
    const places = () => {
      const scene = room();
      setDemoRectangles(scene, 5);
      return scene.componentsOf(Light).map(({ position }) => position.toArray());
    };
    expect(places()).toEqual(places());
    const scene = room();
    setDemoRectangles(scene, 5);
    const [first] = scene.componentsOf(Light);
    setDemoRectangles(scene, 5);
    expect(scene.componentsOf(Light)[0]).toBe(first);
    setDemoRectangles(scene, 0);
    expect(scene.componentsOf(Light)).toHaveLength(0);
    expect(scene.roots.map(({ name }) => name)).toEqual(['Box']);
  });
});
