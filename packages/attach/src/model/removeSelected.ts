import { countLabel, t } from '@farol/editing';
import type { Object3D } from 'three';
import { placementOf, PlaceObjects } from './PlaceObjects';
import type { Session } from './Session';

/**
 * Removes the selected objects, with their descendants, from the scene, as one step of history. Their GPU resources are
 * kept, since the page may use them elsewhere, and undo restores the objects.
 * @throws Error when the page's camera is among them; nothing has changed then
 */
export function removeSelected({ commands, topmost: objects, camera }: Session): void {
  if (objects.length === 0) return;
  for (let above: Object3D | null = camera; above; above = above.parent) {
    if (objects.includes(above)) throw new Error(t('The page is drawn from this camera: delete other objects.'));
  }
  const selection = { done: [], undone: objects };
  commands.run(new PlaceObjects(countLabel(t('Deleted'), objects), 'remove', objects.map(placementOf), selection));
}
