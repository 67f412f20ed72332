import { countLabel, t } from '@farol/editing';
import type { DirectionalLight, Object3D } from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import { placementOf, PlaceObjects } from './PlaceObjects';
import type { Session } from './Session';

/** Copy of an object with its descendants; geometries and materials are shared. */
function copyOf(object: Object3D): Object3D {
  let copy: Object3D;
  try {
    copy = clone(object);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new Error(
      t('{name} cannot be duplicated: its class has no clone() that works ({reason}).', {
        name: object.name || object.type,
        reason,
      }),
      {
        cause,
      },
    );
  }
  const copies: Object3D[] = [];
  copy.traverse((each) => copies.push(each));
  let i = 0;
  // a copied light shares its original's target: three would copy the target too, and nothing would move that copy
  object.traverse((each) => {
    const { target } = each as DirectionalLight;
    const made = copies[i++] as DirectionalLight | undefined;
    if (target?.isObject3D && target.parent && made?.target) made.target = target;
  });
  return copy;
}

/**
 * Inserts a copy after each selected object, and selects the copies, as one step of history.
 * @throws Error as `copyOf` does
 */
export function duplicateSelected({ commands, selection, topmost: objects }: Session): void {
  if (objects.length === 0) return;
  const placements = objects.map((object) => ({ ...placementOf(object), object: copyOf(object) }));
  commands.run(
    new PlaceObjects(
      countLabel(t('Duplicated'), objects),
      'add',
      // inserted after the original, and after earlier copies under the same parent
      placements.map((each) => {
        const before = placements.filter(({ parent, index }) => parent === each.parent && index <= each.index);
        return { ...each, index: each.index + before.length };
      }),
      { done: placements.map(({ object }) => object), undone: selection.items },
    ),
  );
}
