import { GameObject, Light, ObjectRenderer, Scene } from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { describe, expect, it } from 'vitest';
import { alignObjects, distributeObjects, dropToGround } from './alignObjects';

type Triple = [number, number, number];

function box(scene: Scene | GameObject, position: Triple, scale: Triple = [1, 1, 1]): GameObject {
  const object = new GameObject('Box');
  object.addComponent(ObjectRenderer, { mesh: 'box' });
  object.transform.position = position;
  object.transform.scale = scale;
  scene.add(object);
  return object;
}

const worldsOf = (objects: readonly GameObject[]): number[][] =>
  objects.map(({ transform }) => transform.worldPosition.toArray().map((each) => Number(each.toFixed(4)) + 0));

/** Three boxes of different sizes; the last one is below a rotated parent with half the scale. */
function threeBoxes(): { scene: Scene; boxes: GameObject[] } {
  const scene = new Scene();
  const parent = new GameObject('Parent');
  parent.transform.position = [0, 0, 6];
  parent.transform.rotation = [0, Math.PI / 2, 0];
  parent.transform.scale = [0.5, 0.5, 0.5];
  scene.add(parent);
  const boxes = [box(scene, [0, 0, 0]), box(scene, [7, 3, 0], [2, 2, 2]), box(parent, [0, 2, 4], [2, 2, 2])];
  scene.three.updateMatrixWorld();
  return { scene, boxes };
}

describe('alignObjects', () => {
  it('brings the sides of boxes to that of the box round all, in the world', () => {
    const { scene, boxes } = threeBoxes();
    expect(worldsOf(boxes)).toEqual([
      [0, 0, 0],
      [7, 3, 0],
      [2, 1, 6],
    ]);
    alignObjects(scene, boxes, 'y', 'min').do();
    expect(worldsOf(boxes)).toEqual([
      [0, 0, 0],
      [7, 0.5, 0],
      [2, 0, 6],
    ]);
    alignObjects(scene, boxes, 'x', 'max').do();
    expect(worldsOf(boxes)).toEqual([
      [7.5, 0, 0],
      [7, 0.5, 0],
      [7.5, 0, 6],
    ]);
    const command = alignObjects(scene, boxes, 'z', 'centre');
    const before = JSON.stringify(serialize(scene));
    command.do();
    expect(worldsOf(boxes).map(([, , z]) => z)).toEqual([2.75, 2.75, 2.75]);
    command.undo();
    expect(JSON.stringify(serialize(scene))).toBe(before);
    expect(alignObjects(scene, boxes, 'x', 'max').isEmpty).toBe(true);
  });
});

describe('distributeObjects', () => {
  it('makes the gaps equal, or the distances of the middles', () => {
    const { scene, boxes } = threeBoxes();
    // from -0.5 to 8: boxes of 1, 1 and 2 m leave two gaps of 2.25 m
    distributeObjects(scene, boxes, 'x', 'gaps').do();
    expect(worldsOf(boxes).map(([x]) => x)).toEqual([0, 7, 3.25]);
    distributeObjects(scene, boxes, 'x', 'centres').do();
    expect(worldsOf(boxes).map(([x]) => x)).toEqual([0, 7, 3.5]);
  });
});

describe('dropToGround', () => {
  it('puts each onto what is below it, or out of what it is under, or onto the ground', () => {
    const scene = new Scene();
    box(scene, [0, 0.5, 0], [4, 1, 4]);
    const above = box(scene, [1, 8, 1]);
    // only the edge of this box is over the table
    const edge = box(scene, [2.3, 8, 0]);
    const under = box(scene, [30, -4, 0]);
    const light = new GameObject('Light');
    light.addComponent(Light);
    light.transform.position = [-1, 5, -1];
    scene.add(light);
    const all = [above, edge, under, light];
    const command = dropToGround(scene, all);
    command.do();
    expect(worldsOf(all)).toEqual([
      [1, 1.5, 1],
      [2.3, 1.5, 0],
      [30, 0.5, 0],
      [-1, 1, -1],
    ]);
    command.undo();
    expect(worldsOf(all).map(([, y]) => y)).toEqual([8, 8, -4, 5]);
  });
});
