import { Group, Matrix4, Object3D, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { type DragOptions, placePivot, type Pose, TransformDrag, type TransformMode } from './TransformDrag';

/** An object at x = 2 m without a parent, and one in a group that is moved, rotated and scaled by 2. */
function scene(): [Object3D, Object3D] {
  const [free, child] = [new Object3D(), new Object3D()];
  const parent = new Group();
  parent.position.set(10, 0, 0);
  parent.rotation.y = Math.PI / 2;
  parent.scale.setScalar(2);
  parent.add(child);
  child.position.set(0, 0, 1); // at 12, 0, 0 in world space
  free.position.set(2, 0, 0);
  return [free, child];
}

/** Drags objects about a pivot at the position of the first one. */
function drag(
  objects: readonly Object3D[],
  mode: TransformMode,
  move: (pivot: Object3D) => void,
  options?: DragOptions,
): void {
  const pivot = new Object3D();
  for (const object of objects) object.updateWorldMatrix(true, false);
  placePivot(pivot, new Vector3().setFromMatrixPosition(objects[0].matrixWorld), objects[0].matrixWorld);
  const starts = objects.map((object) => ({
    position: object.position.clone(),
    quaternion: object.quaternion.clone(),
    scale: object.scale.clone(),
    parentWorld: object.parent?.matrixWorld ?? new Matrix4(),
  }));
  const transform = new TransformDrag(pivot, starts);
  move(pivot);
  transform.poses(mode, options).forEach((pose, i) => apply(objects[i], pose));
}

function apply(object: Object3D, { position, quaternion, scale }: Partial<Pose>): void {
  if (position) object.position.copy(position);
  if (quaternion) object.quaternion.copy(quaternion);
  if (scale) object.scale.copy(scale);
}

const rounded = (vector: Vector3): number[] => vector.toArray().map((each) => Number(each.toFixed(6)) + 0);
const placeOf = (object: Object3D): number[] => rounded(object.getWorldPosition(new Vector3()));
/** World direction of the object's x axis. */
const axisOf = (object: Object3D): number[] =>
  rounded(new Vector3(1, 0, 0).applyQuaternion(object.getWorldQuaternion(new Quaternion())));

describe('TransformDrag', () => {
  it('moves several together in the world, whatever they hang on', () => {
    const [free, child] = scene();
    drag([free, child], 'translate', (pivot) => pivot.position.add(new Vector3(1, 2, 3)));
    expect([placeOf(free), placeOf(child)]).toEqual([
      [3, 2, 3],
      [13, 2, 3],
    ]);
    expect(axisOf(child)).toEqual([0, 0, -1]);
  });

  it('turns and sizes each in its place, if asked', () => {
    const [free, child] = scene();
    drag([free, child], 'rotate', (pivot) => pivot.rotateY(Math.PI / 2), { each: true });
    drag([free, child], 'scale', (pivot) => pivot.scale.set(3, 1, 1), { each: true });
    expect([placeOf(free), placeOf(child)]).toEqual([
      [2, 0, 0],
      [12, 0, 0],
    ]);
    expect([axisOf(free), axisOf(child)]).toEqual([
      [0, 0, -1],
      [-1, 0, 0],
    ]);
    expect([free.scale.x, child.scale.x]).toEqual([3, 3]);
  });

  it('turns what moves with the pivot, if asked', () => {
    const [free, child] = scene();
    const move = (pivot: Object3D): void => void pivot.rotateY(Math.PI / 2).position.set(2, 5, 0);
    drag([free, child], 'translate', move, { turns: true });
    expect([placeOf(free), placeOf(child)]).toEqual([
      [2, 5, 0],
      [2, 5, -10],
    ]);
    expect([axisOf(free), axisOf(child)]).toEqual([
      [0, 0, -1],
      [-1, 0, 0],
    ]);
  });

  it('turns several about the pivot, one in its place', () => {
    const [free, child] = scene();
    const turn = (pivot: Object3D) => void pivot.rotateZ(Math.PI / 2);
    drag([free, child], 'rotate', turn);
    expect([placeOf(free), placeOf(child)]).toEqual([
      [2, 0, 0],
      [2, 10, 0],
    ]);
    expect([axisOf(free), axisOf(child)]).toEqual([
      [0, 1, 0],
      [0, 0, -1],
    ]);
    const [, alone] = scene();
    drag([alone], 'rotate', (pivot) => void pivot.rotateZ(Math.PI / 2));
    expect([placeOf(alone), alone.position.toArray()]).toEqual([
      [12, 0, 0],
      [0, 0, 1],
    ]);
    expect(axisOf(alone)).toEqual([0, 1, 0]);
  });

  it('scales several away from the pivot, one in its place, and each by its own size', () => {
    const [free, child] = scene();
    child.scale.set(1, 2, 3);
    drag([free, child], 'scale', (pivot) => pivot.scale.set(2, 1, 1));
    expect([placeOf(free), placeOf(child)]).toEqual([
      [2, 0, 0],
      [22, 0, 0],
    ]);
    expect([free.scale.toArray(), child.scale.toArray()]).toEqual([
      [2, 1, 1],
      [2, 2, 3],
    ]);
    const [alone] = scene();
    drag([alone], 'scale', (pivot) => pivot.scale.set(1, 3, 1));
    expect([placeOf(alone), alone.scale.toArray()]).toEqual([
      [2, 0, 0],
      [1, 3, 1],
    ]);
  });
});
