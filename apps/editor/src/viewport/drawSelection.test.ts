import { Decal, GameObject, Light, Scene } from '@farol/engine';
import { Box3, Matrix4, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { drawSelection } from './drawSelection';
import type { LineSet } from './LineSet';

test('a selected decal shows its box, turned and scaled as it is, and the way it is thrown', () => {
  const object = new GameObject('Stain');
  object.addComponent(Decal, { size: [2, 4, 6] });
  object.transform.position = [1, 2, 3];
  new Scene().add(object);
  object.object3D.updateWorldMatrix(true, false);
  const boxes: { box: Box3; matrix: Matrix4 }[] = [];
  const drawn: [Vector3, Vector3][] = [];
  const lines = {
    box: (box: Box3, matrix: Matrix4) => boxes.push({ box: box.clone(), matrix }),
    line: (from: Vector3, to: Vector3) => drawn.push([from.clone(), to.clone()]),
  } as unknown as LineSet;
  drawSelection(lines, [object], null);
  expect(boxes).toHaveLength(1);
  expect(boxes[0].box).toEqual(new Box3(new Vector3(-1, -2, -3), new Vector3(1, 2, 3)));
  expect(boxes[0].matrix).toEqual(object.object3D.matrixWorld);
  expect(drawn[0]).toEqual([new Vector3(1, 2, 6), new Vector3(1, 2, 0)]);
  expect(drawn).toHaveLength(3);
});

test('of many selected lights the range of the one chosen last is drawn alone', () => {
  const scene = new Scene();
  const lamps = Array.from({ length: 41 }, (_, i) => {
    const lamp = new GameObject(`Lamp ${i}`);
    lamp.addComponent(Light, { type: 'point', range: 2 });
    lamp.transform.position = [10 * i, 0, 0];
    scene.add(lamp);
    return lamp;
  });
  scene.update(0);
  scene.three.updateMatrixWorld();
  /** x coordinates of line ends, in tens. */
  const places = (objects: readonly GameObject[]): number[] => {
    const found = new Set<number>();
    const note = (point: Vector3): unknown => found.add(Math.round(point.x / 10));
    const lines = { line: (from: Vector3, to: Vector3) => [from, to].forEach(note), circle: note };
    drawSelection(lines as unknown as LineSet, objects, null);
    return [...found];
  };
  expect(places(lamps.slice(0, 8))).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
  expect(places(lamps)).toEqual([40]);
});
