import type { DirectionalLight, Object3D } from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import { Place } from './Place';
import type { Session } from './Session';

/** A copy with all below it; geometries and materials are shared. @throws Error for a class that cannot be copied */
function copyOf(object: Object3D): Object3D {
  let copy: Object3D;
  try {
    copy = clone(object);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new Error(
      `${object.name || object.type} cannot be duplicated: its class has no clone() that works (${reason}).`,
      {
        cause,
      },
    );
  }
  const copies: Object3D[] = [];
  copy.traverse((each) => copies.push(each));
  let i = 0;
  // a light goes on shining on what it shone on: three copies the target, and nobody would move the copy
  object.traverse((each) => {
    const { target } = each as DirectionalLight;
    const made = copies[i++] as DirectionalLight | undefined;
    if (target?.isObject3D && target.parent && made?.target) made.target = target;
  });
  return copy;
}

/** Puts a copy of each selected object after it, and selects the copies: one step of history. @throws Error as `copyOf` does */
export function duplicateSelected(session: Session): void {
  const objects = session.topmost;
  if (objects.length === 0) return;
  const before = session.selection;
  const made = objects.map((object) => ({ object, copy: copyOf(object) }));
  // each as it is placed: those before it count
  const places = made.map(({ object, copy }) => {
    const place = new Place(copy, object.parent!, object.parent!.children.indexOf(object) + 1);
    place.fill();
    return place;
  });
  const copies = made.map(({ copy }) => copy);
  session.selection = copies;
  session.history.keep({
    label: `duplicate of ${objects.length === 1 ? objects[0].name || objects[0].type : `${objects.length} objects`}`,
    undo() {
      for (const place of places.toReversed()) place.clear();
      session.selection = before;
    },
    redo() {
      for (const place of places) place.fill();
      session.selection = copies;
    },
  });
}
