import { describe, expect, test } from 'vitest';
import type { EngineKeyEvent, EnginePointerEvent } from '../core/events';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import './index';
import { RandomMovement } from './RandomMovement';

const key = (type: 'down' | 'up', code: string, extra: Partial<EngineKeyEvent> = {}): EngineKeyEvent => ({
  ...{ type, code, key: '', repeat: false, shiftKey: false, ctrlKey: false, altKey: false, metaKey: false },
  ...extra,
});

const drag = (dx: number, dy: number, buttons = 1): EnginePointerEvent => ({
  ...{ type: 'move', x: 0, y: 0, dx, dy, ndcX: 0, ndcY: 0, button: -1, buttons, pointerId: 1, wheel: 0 },
  ...{ shiftKey: false, ctrlKey: false, altKey: false, metaKey: false },
});

function walker(...types: string[]): { scene: Scene; object: GameObject } {
  const scene = new Scene();
  const object = new GameObject('Walker');
  for (const type of types) object.addComponent(type);
  scene.add(object);
  return { scene, object };
}

describe('KeyController', () => {
  test('goes along front and right at its speed, while the key is held', () => {
    const { scene, object } = walker('KeyController');
    object.transform.rotation = [0, Math.PI / 2, 0];
    scene.dispatchKey(key('down', 'KeyW'));
    scene.update(0.5);
    expect(object.transform.position[0]).toBeCloseTo(-2.5, 9);
    scene.dispatchKey(key('up', 'KeyW'));
    scene.update(0.5);
    expect(object.transform.position[0]).toBeCloseTo(-2.5, 9);
    scene.dispatchKey(key('down', 'ArrowRight', { shiftKey: true }));
    scene.update(0.1);
    expect(object.transform.position[2]).toBeCloseTo(-2, 9);
  });

  test('is not an edit, and leaves short cuts alone', () => {
    const { scene, object } = walker('KeyController');
    const { revision } = scene;
    scene.dispatchKey(key('down', 'KeyS', { ctrlKey: true }));
    scene.update(1);
    expect(object.transform.position).toEqual([0, 0, 0]);
    scene.dispatchKey(key('down', 'KeyS'));
    scene.update(1);
    expect(object.transform.position).not.toEqual([0, 0, 0]);
    expect(object.transform.getAuthored('position')).toEqual([0, 0, 0]);
    expect(scene.revision).toBe(revision);
  });

  test('lets go when it is switched off', () => {
    const { scene, object } = walker('KeyController');
    scene.dispatchKey(key('down', 'KeyW'));
    object.active = false;
    object.active = true;
    scene.update(1);
    expect(object.transform.position).toEqual([0, 0, 0]);
  });
});

describe('fingers', () => {
  const finger = (type: 'down' | 'move' | 'up', extra: Partial<EnginePointerEvent>): EnginePointerEvent => ({
    ...drag(0, 0, type === 'up' ? 0 : 1),
    ...{ type, pointerType: 'touch' as const },
    ...extra,
  });

  test('on the left half moves, slower for a shorter drag, and stops where it is lifted', () => {
    const { scene, object } = walker('KeyController', 'MouseController');
    scene.dispatchPointer(finger('down', { ndcX: -0.5, x: 90, y: 200 }));
    scene.dispatchPointer(finger('move', { ndcX: -0.5, x: 90, y: 170, dy: -30 }));
    scene.update(1);
    expect(object.transform.position[2]).toBeCloseTo(-2.5, 9);
    scene.dispatchPointer(finger('move', { ndcX: 0.5, x: 390, y: 200, dx: 300, dy: 30 }));
    scene.update(1);
    expect(object.transform.position[0], 'at most at full speed').toBeCloseTo(5, 9);
    expect(object.transform.rotation, 'it turns nothing').toEqual([0, 0, 0]);
    scene.dispatchPointer(finger('up', { ndcX: 0.5 }));
    scene.update(1);
    expect(object.transform.position[0]).toBeCloseTo(5, 9);
  });

  test('on the right half turns while another moves', () => {
    const { scene, object } = walker('KeyController', 'MouseController');
    scene.dispatchPointer(finger('down', { ndcX: -0.5, x: 90, y: 200 }));
    scene.dispatchPointer(finger('down', { ndcX: 0.5, x: 300, y: 200, pointerId: 2 }));
    scene.dispatchPointer(finger('move', { ndcX: 0.5, x: 200, y: 200, dx: -100, pointerId: 2 }));
    expect(object.transform.rotation[1]).toBeCloseTo(0.4, 9);
    scene.update(1);
    expect(object.transform.position).toEqual([0, 0, 0]);
  });

  test('lets go when the component is switched off', () => {
    const { scene, object } = walker('KeyController');
    scene.dispatchPointer(finger('down', { ndcX: -0.5, x: 90, y: 200 }));
    scene.dispatchPointer(finger('move', { ndcX: -0.5, x: 90, y: 100, dy: -100 }));
    object.active = false;
    object.active = true;
    scene.update(1);
    expect(object.transform.position).toEqual([0, 0, 0]);
  });
});

describe('MouseController', () => {
  test('turns sideways about the vertical of the world, and never tilts', () => {
    const { scene, object } = walker('MouseController');
    for (const [dx, dy] of [
      [120, 40],
      [-30, 70],
      [200, -90],
    ]) {
      scene.dispatchPointer(drag(dx, dy));
      expect(object.transform.right.y).toBeCloseTo(0, 9);
    }
    expect(object.transform.front.x).toBeGreaterThan(0);
  });

  test('stops at its pitch limit', () => {
    const { scene, object } = walker('MouseController');
    scene.dispatchPointer(drag(0, -5000));
    expect(Math.asin(object.transform.front.y)).toBeCloseTo(1.5, 6);
    scene.dispatchPointer(drag(0, 9000));
    expect(Math.asin(object.transform.front.y)).toBeCloseTo(-1.5, 6);
  });

  test('an object that leans beyond the pitch limit may come back, and does not jump', () => {
    const { scene, object } = walker('MouseController');
    object.transform.rotation = [1.55, 0, 0];
    scene.dispatchPointer(drag(0, -1));
    expect(Math.asin(object.transform.front.y)).toBeCloseTo(1.55, 6);
    scene.dispatchPointer(drag(0, 10));
    expect(Math.asin(object.transform.front.y)).toBeCloseTo(1.51, 6);
  });

  test('wants its button held', () => {
    const { scene, object } = walker('MouseController');
    scene.dispatchPointer(drag(100, 0, 0));
    scene.dispatchPointer(drag(100, 0, 2));
    expect(object.transform.rotation).toEqual([0, 0, 0]);
  });
});

describe('RandomMovement', () => {
  const pathOf = (seed: number, times: number[]): number[][] => {
    const { scene, object } = walker();
    object.transform.position = [10, 20, 30];
    object.addComponent(RandomMovement, { seed, extent: [3, 1, 2], speed: 2 });
    return times.map((time) => {
      scene.setTime(time);
      return [...object.transform.position];
    });
  };

  test('is a function of seed and time alone, in whatever order the times come', () => {
    const forward = pathOf(5, [0, 1, 2.5, 100]);
    expect(pathOf(5, [100, 2.5, 1, 0]).toReversed()).toEqual(forward);
    expect(pathOf(6, [1])[0]).not.toEqual(forward[1]);
  });

  test('small steps and one leap come to the same place', () => {
    const { scene, object } = walker('RandomMovement');
    for (let i = 0; i < 8; i++) scene.update(0.25);
    const stepped = object.transform.position;
    scene.setTime(2);
    expect(object.transform.position).toEqual(stepped);
  });

  test('begins at its place, stays within its extent and below its speed', () => {
    const step = 0.01;
    const times = Array.from({ length: 3000 }, (_, i) => i * step);
    const path = pathOf(7, times);
    expect(path[0]).toEqual([10, 20, 30]);
    let travelled = 0;
    path.forEach((position, i) => {
      [3, 1, 2].forEach((extent, axis) => {
        expect(Math.abs(position[axis] - [10, 20, 30][axis])).toBeLessThanOrEqual(extent + 1e-9);
        if (i === 0) return;
        const way = Math.abs(position[axis] - path[i - 1][axis]);
        expect(way).toBeLessThanOrEqual(2 * step + 1e-9);
        travelled += way;
      });
    });
    expect(travelled).toBeGreaterThan(30);
  });

  test('follows its place when that is edited, and goes back to it when it is switched off or taken away', () => {
    const { scene, object } = walker('RandomMovement');
    const movement = object.getComponent(RandomMovement)!;
    scene.setTime(3);
    const offset = object.transform.position.map((value) => value);
    object.transform.position = [100, 0, 0];
    scene.setTime(3);
    expect(object.transform.position[0]).toBeCloseTo(100 + offset[0], 9);
    movement.enabled = false;
    expect(object.transform.position).toEqual([100, 0, 0]);
    movement.enabled = true;
    scene.update(1);
    expect(object.transform.position).not.toEqual([100, 0, 0]);
    object.removeComponent(movement);
    expect(object.transform.position).toEqual([100, 0, 0]);
  });
});
