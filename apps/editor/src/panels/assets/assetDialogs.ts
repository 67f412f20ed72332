import { t, tCount } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import type { AssetEntry } from '../../files/assetKinds';
import { canRename, joinName, splitName } from '../../model/assetNames';
import { deleteAsset, usagesOf } from '../../model/assetUsages';
import { Sequence } from '../../model/commands/Sequence';
import { deletePrefab, instancesOf, renamePrefab } from '../../model/prefabEdits';
import { renameAnyAsset } from '../../model/scriptEdits';

/** Checks that an asset can be deleted. @throws Error with the reason when not */
function checkRemovable({ document }: EditorApi, { isBuiltin, label, name }: AssetEntry): void {
  if (isBuiltin) throw new Error(t('{label} came with Farol, and cannot be deleted.', { label }));
  const model = document.assets.modelOf(name);
  if (model) throw new Error(t('{label} is a part of {model}: delete that.', { label, model }));
}

/** Deletes assets and prefabs in one step of history. When one is in use, first asks, with a list of all its uses. */
export async function removeEntries(editor: EditorApi, entries: readonly AssetEntry[]): Promise<void> {
  const { document, commands, dialogs } = editor;
  const { scene } = document;
  for (const entry of entries) checkRemovable(editor, entry);
  const usages = entries.flatMap(({ kind, name }) => {
    const becomesOwn = t('becomes an object of its own.');
    if (kind === 'prefab')
      return instancesOf(scene, name).map((object) => ({ path: object.name, problem: becomesOwn }));
    return usagesOf(scene, name).map(({ place, field }) => ({
      path: place,
      problem:
        kind === 'script'
          ? t('{field} is kept as data, and does nothing.', { field })
          : t('{field} becomes empty.', { field }),
    }));
  });
  const what = tCount(entries.length, '{label}', '{count} assets', { label: entries[0].label });
  if (usages.length > 0) {
    const agreed = await dialogs.show({
      kind: 'problems',
      title: t('Delete {label}?', { label: what }),
      text: tCount(
        usages.length,
        'It is used in {count} place. The step can be undone.',
        'It is used in {count} places. The step can be undone.',
      ),
      problems: usages,
      action: t('Delete'),
    });
    if (!agreed) return;
  }
  const made = entries.map(({ kind, name }) => () => {
    const prefab = kind === 'prefab' ? scene.prefabs.get(name) : null;
    return prefab ? deletePrefab(scene, prefab, document.selection.ids) : deleteAsset(scene, name);
  });
  commands.run(made.length === 1 ? made[0]() : new Sequence(t('Deleted {label}', { label: what }), made));
  document.assetSelection.clear();
}

/** Asks for a new name of an asset or a prefab. */
export function renameEntry(editor: EditorApi, entry: AssetEntry): void {
  const { document, commands, dialogs } = editor;
  const { scene, assets } = document;
  const prefab = entry.kind === 'prefab' ? scene.prefabs.get(entry.name) : null;
  if (!prefab && !canRename(assets, entry.name))
    throw new Error(t('{label} keeps its name: it came with Farol, or is a part of a model.', { label: entry.label }));
  const { folder, leaf: before } = splitName(prefab?.name ?? entry.name);
  void dialogs.show({
    kind: 'text',
    title: t('Rename {name}', { name: before }),
    label: prefab ? t('Name of the prefab') : t('Name of the asset'),
    value: before,
    action: t('Rename'),
    accept: (name) => {
      if (name === before) return;
      if (prefab) return commands.run(renamePrefab(scene, prefab, joinName(folder, name)));
      const isSelected = document.assetSelection.has(entry.name);
      const others = new Set(assets.list());
      commands.run(renameAnyAsset(scene, entry.name, joinName(folder, name)));
      const next = assets.list().find((each) => !others.has(each) && assets.modelOf(each) === null);
      if (isSelected && next !== undefined) document.assetSelection.set([next]);
    },
  });
}
