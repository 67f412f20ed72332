import { countLabel, t } from '@farol/editing';
import type { Object3D } from 'three';
import { placementOf, PlaceObjects } from './PlaceObjects';
import type { Session } from './Session';

/**
 * Takes the selected objects, with all below them, out of the scene: one step of history. What they hold on the GPU stays,
 * since the page may use it elsewhere, and an undo brings them back.
 * @throws Error when the page looks through one of them; nothing has changed then
 */
export function removeSelected({ commands, topmost: objects, camera }: Session): void {
  if (objects.length === 0) return;
  for (let above: Object3D | null = camera; above; above = above.parent) {
    if (objects.includes(above)) throw new Error(t('The page is drawn from this camera: it cannot be deleted.'));
  }
  const selection = { done: [], undone: objects };
  commands.run(new PlaceObjects(countLabel(t('Deleted'), objects), 'remove', objects.map(placementOf), selection));
}
