import { t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { instantiatePrefab, type Prefab } from '@farol/engine/prefabs';
import type { EditorApi } from '../../api/EditorApi';
import { bringAssets, renamedObjects } from '../../model/bringAssets';
import { AddAssets } from '../../model/commands/AddAssets';
import { Sequence } from '../../model/commands/Sequence';
import { SetPrefab } from '../../model/commands/SetPrefab';
import { addObject } from '../../model/edits';
import { buildLibraryItem } from '../../model/library/buildLibraryItem';
import type { BuiltItem } from '../../model/library/parts';
import { canPlacePrefab } from '../../model/prefabEdits';
import { land } from '../../viewport/placing/land';
import { landingView, loadShapes, pointInPicture } from '../landInPicture';
import type { DropPlace } from '../placeAsset';

/** Item's prefab with assets named as in a scene, and commands that add what the scene lacks. */
function bring(
  scene: Scene,
  { prefab, assets }: BuiltItem,
): { prefab: Prefab; steps: (() => AddAssets | SetPrefab)[] } {
  const known = scene.prefabs.get(prefab.id);
  if (known) return { prefab: known, steps: [] };
  const brought = bringAssets(scene, assets, new Map());
  const named = { ...prefab, objects: renamedObjects(scene, prefab.objects, brought, {}) };
  const add = () => new AddAssets(scene.assets, brought.taken);
  const set = () => new SetPrefab(scene, named.id, named);
  return { prefab: named, steps: brought.taken.length > 0 ? [add, set] : [set] };
}

/**
 * Places an instance of a library's item, as one step; the scene gets its prefab and materials with the first one.
 * @param id - such as 'street-lamp'
 */
export async function placeLibraryItem(editor: EditorApi, id: string, place: DropPlace = {}): Promise<void> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  const item = buildLibraryItem(id);
  if (!item) throw new Error(t('The library does not have it any more.'));
  const sample = instantiatePrefab(item.prefab, scene.registry);
  await loadShapes(editor, [sample]);
  sample.dispose();
  if (scene !== document.scene) return;
  const { prefab, steps } = bring(scene, item);
  const instance = instantiatePrefab(prefab, scene.registry);
  const { parent = scene } = place;
  const container = canPlacePrefab(scene, prefab, parent) ? parent : scene;
  if (container === scene) {
    // first, since it activates the view under the point
    const point = pointInPicture(editor, place.at);
    land(landingView(editor), [instance], point);
  }
  const put = addObject(scene, instance, container, selection.ids);
  commands.run(new Sequence(put.label, [...steps, () => put], put.selection));
}
