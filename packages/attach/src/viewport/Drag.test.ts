import { Group, Object3D, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { Drag } from './Drag';

const placeOf = (object: Object3D): number[] =>
  object
    .getWorldPosition(new Vector3())
    .toArray()
    .map((each) => Number(each.toFixed(6)));

it('has others follow in the world, whatever they hang on, and puts all back', () => {
  const [leader, other] = [new Object3D(), new Object3D()];
  const parent = new Group();
  parent.position.set(10, 0, 0);
  parent.rotation.y = Math.PI / 2;
  parent.scale.setScalar(2);
  parent.add(other);
  other.position.set(0, 0, 1); // in the world at 12, 0, 0
  leader.position.set(2, 0, 0);
  const drag = new Drag(leader, [other]);
  leader.position.x = 3;
  leader.rotation.z = Math.PI / 2; // about the leader
  drag.follow(false);
  expect(placeOf(other)).toEqual([3, 10, 0]);
  const redo = drag.finish()!;
  drag.undo();
  expect([placeOf(leader), placeOf(other)]).toEqual([
    [2, 0, 0],
    [12, 0, 0],
  ]);
  redo();
  expect(placeOf(other)).toEqual([3, 10, 0]);
});

it('scales each in its place, and knows when nothing was dragged', () => {
  const [leader, other] = [new Object3D(), new Object3D()];
  other.position.x = 4;
  other.scale.set(1, 2, 3);
  const drag = new Drag(leader, [other]);
  expect(drag.finish()).toBe(null);
  leader.scale.set(2, 1, 1);
  drag.follow(true);
  expect(other.scale.toArray()).toEqual([2, 2, 3]);
  expect(other.position.x).toBe(4);
});
