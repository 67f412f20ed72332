import { type Command, countLabel, t } from '@farol/editing';
import { GameObject, type Scene } from '@farol/engine';
import { Vector3 } from 'three';
import { MoveObjects } from './commands/MoveObjects';
import { type Placement, placementOf, topmost } from './commands/Placement';
import { PlaceObjects } from './commands/PlaceObjects';
import { Sequence } from './commands/Sequence';
import { followTracks } from './timeline/followTracks';
import { UniqueNames } from './UniqueNames';

const none = { done: [], undone: [] };

/** Centroid of objects, in the space of a parent. */
function middleOf(objects: readonly GameObject[], { parent }: Placement): Vector3 {
  const middle = new Vector3();
  for (const { transform } of objects) middle.add(transform.worldPosition);
  middle.divideScalar(objects.length);
  if (!(parent instanceof GameObject)) return middle;
  parent.object3D.updateWorldMatrix(true, false);
  return parent.object3D.worldToLocal(middle);
}

/**
 * Makes objects children of a new one at their centroid, at the first object's place in the tree. World poses stay.
 * @param objects - at least one
 */
export function groupObjects(scene: Scene, objects: readonly GameObject[]): Command {
  const tops = topmost(objects, scene);
  const place = placementOf(tops[0], scene);
  const group = new GameObject(new UniqueNames(scene).take(t('Group')));
  group.transform.position = middleOf(tops, place).toArray();
  const grouped = new Sequence(
    countLabel(t('Grouped'), tops),
    [
      () => new PlaceObjects('Add group', scene, 'add', [{ ...place, object: group }], none),
      () => new MoveObjects('Move into group', scene, tops, group, null),
    ],
    { done: [group.id], undone: objects.map(({ id }) => id) },
  );
  return followTracks(scene, grouped);
}

/** Replaces objects by their children, whose world poses stay. */
export function ungroupObjects(scene: Scene, objects: readonly GameObject[]): Command {
  const groups = topmost(objects, scene).filter(({ children }) => children.length > 0);
  const freed = groups.flatMap(({ children }) => [...children]);
  const steps = groups.flatMap((group) => [
    () => {
      const { parent, index } = placementOf(group, scene);
      const next = ('roots' in parent ? parent.roots : parent.children)[index + 1] ?? null;
      return new MoveObjects('Move out of group', scene, [...group.children], parent, next);
    },
    () => new PlaceObjects('Delete group', scene, 'remove', [placementOf(group, scene)], none),
  ]);
  const ungrouped = new Sequence(
    groups.length === 1
      ? t('Ungrouped {name}', { name: groups[0].name })
      : t('Ungrouped {count} groups', { count: groups.length }),
    steps,
    {
      done: freed.map(({ id }) => id),
      undone: objects.map(({ id }) => id),
    },
  );
  return followTracks(scene, ungrouped);
}
