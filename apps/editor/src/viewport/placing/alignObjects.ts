import { type Command, countLabel, SetFields, t, tCount } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import { Box3, Vector3 } from 'three';
import { topmost } from '../../model/commands/Placement';
import { boundsOf } from '../boundsOf';
import { moveInWorld } from './moveInWorld';
import { SurfaceBelow } from './SurfaceBelow';

export type Axis = 'x' | 'y' | 'z';
/** Side of a box along an axis: least, middle or greatest coordinate. */
export type AlignSide = 'min' | 'centre' | 'max';

/** An object with the bounds of its meshes; its position when it has none. */
interface Boxed {
  readonly object: GameObject;
  readonly box: Box3;
}

function boxed(scene: Scene, objects: readonly GameObject[]): Boxed[] {
  scene.three.updateMatrixWorld();
  return topmost(objects, scene).map((object) => {
    const box = boundsOf([object], new Box3());
    return { object, box: box.isEmpty() ? new Box3().expandByPoint(object.transform.worldPosition) : box };
  });
}

const sideOf = ({ min, max }: Box3, axis: Axis, side: AlignSide): number =>
  side === 'min' ? min[axis] : side === 'max' ? max[axis] : (min[axis] + max[axis]) / 2;

const objectsOf = (parts: readonly Boxed[]): GameObject[] => parts.map(({ object }) => object);

const moved = (label: string, parts: readonly Boxed[], ways: readonly Vector3[]): Command =>
  new SetFields(label, moveInWorld(objectsOf(parts), ways));

/**
 * Moves objects along a world axis to align one side of their boxes with that of their common box.
 * @param objects - at least one; descendants of another are ignored
 */
export function alignObjects(scene: Scene, objects: readonly GameObject[], axis: Axis, side: AlignSide): Command {
  const parts = boxed(scene, objects);
  const all = parts.reduce((sum, { box }) => sum.union(box), new Box3());
  const targetSide = sideOf(all, axis, side);
  const ways = parts.map(({ box }) =>
    new Vector3().setComponent('xyz'.indexOf(axis), targetSide - sideOf(box, axis, side)),
  );
  return moved(countLabel(t('Aligned'), objectsOf(parts)), parts, ways);
}

/**
 * Moves objects along a world axis, except the first and the last, to make distances equal.
 * @param by - 'gaps' between boxes, or 'centres' between their centres
 * @param objects - at least one; descendants of another are ignored
 */
export function distributeObjects(
  scene: Scene,
  objects: readonly GameObject[],
  axis: Axis,
  by: 'gaps' | 'centres',
): Command {
  const parts = boxed(scene, objects);
  const size = ({ box }: Boxed): number => box.max[axis] - box.min[axis];
  const middle = ({ box }: Boxed): number => sideOf(box, axis, 'centre');
  const order = parts.toSorted((a, b) => middle(a) - middle(b));
  const [first, last] = [order[0], order[order.length - 1]];
  const ways = new Map<Boxed, number>();
  if (by === 'centres') {
    const step = (middle(last) - middle(first)) / Math.max(1, order.length - 1);
    order.forEach((part, i) => ways.set(part, middle(first) + i * step - middle(part)));
  } else {
    const taken = order.reduce((sum, part) => sum + size(part), 0);
    const gap = (last.box.max[axis] - first.box.min[axis] - taken) / Math.max(1, order.length - 1);
    let at = first.box.min[axis];
    for (const part of order) {
      ways.set(part, at - part.box.min[axis]);
      at += size(part) + gap;
    }
  }
  return moved(
    countLabel(t('Distributed'), objectsOf(parts)),
    parts,
    parts.map((part) => new Vector3().setComponent('xyz'.indexOf(axis), ways.get(part)!)),
  );
}

/** Share of a box's footprint within which surfaces below are searched. */
const INSIDE = 0.9;

/**
 * Moves objects onto the surface below them, or above when they are under it; else onto the ground at height 0. The
 * objects are not dropped onto each other.
 * @param objects - at least one; descendants of another are ignored
 */
export function dropToGround(scene: Scene, objects: readonly GameObject[]): Command {
  const parts = boxed(scene, objects);
  const below = new SurfaceBelow(scene, new Set(objects));
  const ways = parts.map(({ box }) => {
    const centre = box.getCenter(new Vector3());
    const half = box.getSize(new Vector3()).multiplyScalar(INSIDE / 2);
    const heights = [
      [0, 0],
      [-1, -1],
      [-1, 1],
      [1, -1],
      [1, 1],
    ].map(([x, z]) => below.heightAt({ x: centre.x + x * half.x, y: box.min.y, z: centre.z + z * half.z }));
    return new Vector3(0, Math.max(...heights) - box.min.y, 0);
  });
  const label =
    parts.length === 1
      ? t('Dropped {name} to the ground', { name: parts[0].object.name })
      : tCount(parts.length, 'Dropped {count} object to the ground', 'Dropped {count} objects to the ground');
  return moved(label, parts, ways);
}
