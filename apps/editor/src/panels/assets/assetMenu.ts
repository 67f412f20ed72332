import { t, tCount } from '@farol/editing';
import { importModel } from '@farol/engine';
import type { EditorApi } from '../../api/EditorApi';
import { type AssetEntry, isEnvironment } from '../../files/assetKinds';
import { placeAsset, useAsEnvironment } from '../../files/placeAsset';
import { deleteAsset, usagesOf } from '../../model/assetUsages';
import { addObject } from '../../model/edits';
import { deletePrefab, instancesOf, renamePrefab } from '../../model/prefabEdits';
import type { MenuEntry } from '../../api/MenuEntry';

/** Deletes an asset or a prefab; where it is used, the user is asked first, with every place by name. */
export async function removeEntry(editor: EditorApi, entry: AssetEntry): Promise<void> {
  const { document, commands, dialogs } = editor;
  const { scene } = document;
  if (entry.isBuiltin) throw new Error(t('{label} came with Farol, and cannot be deleted.', { label: entry.label }));
  const model = document.assets.modelOf(entry.name);
  if (model) throw new Error(t('{label} is a part of {model}: delete that.', { label: entry.label, model }));
  const prefab = entry.kind === 'prefab' ? scene.prefabs.get(entry.name) : null;
  const usages = prefab
    ? instancesOf(scene, prefab.id).map(({ name }) => ({ path: name, problem: t('becomes an object of its own.') }))
    : usagesOf(scene, entry.name).map(({ place, field }) => ({
        path: place,
        problem: t('{field} becomes empty.', { field }),
      }));
  if (usages.length > 0) {
    const agreed = await dialogs.show({
      kind: 'problems',
      title: t('Delete {label}?', { label: entry.label }),
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
  if (prefab) commands.run(deletePrefab(scene, prefab, document.selection.ids));
  else if (entry.kind !== 'prefab') commands.run(deleteAsset(scene, entry.name));
}

/** Asks for another name of a prefab. */
export function renameEntry(editor: EditorApi, entry: AssetEntry): void {
  const { document, commands, dialogs } = editor;
  const { scene } = document;
  const prefab = scene.prefabs.get(entry.name);
  if (entry.kind !== 'prefab' || !prefab)
    throw new Error(t('{label} cannot be renamed: only prefabs can.', { label: entry.label }));
  void dialogs.show({
    kind: 'text',
    title: t('Rename {name}', { name: prefab.name }),
    label: t('Name of the prefab'),
    value: prefab.name,
    action: t('Rename'),
    accept: (name) => {
      if (name !== prefab.name) commands.run(renamePrefab(scene, prefab, name));
    },
  });
}

/** Puts the parts of a model into the scene, each an object that can be edited. */
function unpackModel(editor: EditorApi, name: string): void {
  const { document, commands, viewport } = editor;
  const object = importModel(document.assets.model(name), document.assets, name);
  object.name = name.replace(/\.\w+$/, '');
  object.transform.position = viewport.editorCamera.target.toArray();
  commands.run(addObject(document.scene, object, document.scene, document.selection.ids));
}

/** Lines of the context menu of a card. */
export function assetMenu(editor: EditorApi, entry: AssetEntry): MenuEntry[] {
  const { document } = editor;
  const attempt = (run: () => unknown) => (): void => editor.attempt(run);
  const entries: MenuEntry[] = [];
  if (entry.kind === 'texture') {
    const run = attempt(async () => {
      await document.assets.load(entry.name);
      useAsEnvironment(editor, entry.name);
    });
    const help = t('Lights every surface, and is seen behind.');
    entries.push({ label: t('Use as environment'), icon: 'world', help, run });
  }
  if (entry.kind !== 'texture' || !isEnvironment(entry.name)) {
    const label = entry.kind === 'material' || entry.kind === 'shader' ? t('Place on a sphere') : t('Place in scene');
    entries.push({ label, icon: 'add', run: attempt(() => placeAsset(editor, entry)) });
  }
  if (entry.kind === 'model') {
    const help = t('Each mesh becomes an object that can be edited; skeletons and animations are left out.');
    const run = attempt(async () => {
      await document.assets.load(entry.name);
      unpackModel(editor, entry.name);
    });
    entries.push({ label: t('Place as objects'), icon: 'tree', help, run });
  }
  if (entry.kind === 'prefab') {
    const select = (): void => document.selection.set(instancesOf(document.scene, entry.name).map(({ id }) => id));
    entries.push(
      { label: t('Select instances'), icon: 'select', run: select },
      { label: t('Rename…'), keys: 'F2', run: attempt(() => renameEntry(editor, entry)) },
    );
  }
  const disabled = entry.isBuiltin || document.assets.modelOf(entry.name) !== null;
  entries.push('separator', {
    label: t('Delete…'),
    icon: 'remove',
    keys: 'Delete',
    disabled,
    run: attempt(() => removeEntry(editor, entry)),
  });
  return entries;
}
