import type { Object3D } from 'three';
import { Place } from './Place';
import type { Session } from './Session';

const nameOf = (objects: readonly Object3D[]): string =>
  objects.length === 1 ? objects[0].name || objects[0].type : `${objects.length} objects`;

/**
 * Takes the selected objects, with all below them, out of the scene: one step of history. What they hold on the GPU stays,
 * since the page may use it elsewhere, and an undo brings them back.
 * @throws Error when the page looks through one of them; nothing has changed then
 */
export function removeSelected(session: Session): void {
  const objects = session.topmost;
  if (objects.length === 0) return;
  for (let above: Object3D | null = session.camera; above; above = above.parent) {
    if (objects.includes(above)) throw new Error('The page looks through this camera: it cannot be deleted.');
  }
  const places = objects.map((object) => new Place(object, object.parent!));
  const redo = (): void => {
    for (const place of places) place.clear();
    session.selection = [];
  };
  // in the order of their places: each index counts those before it
  const undo = (): void => {
    for (const place of places.toSorted((a, b) => a.index - b.index)) place.fill();
    session.selection = objects;
  };
  redo();
  session.history.keep({ label: `delete of ${nameOf(objects)}`, undo, redo });
}
