import { t } from '@farol/editing';
import { ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { EditorApi } from '../../api/EditorApi';
import type { MenuCommand, MenuEntry } from '../../api/MenuEntry';
import { assetEntries, assetEntry, type AssetEntry, isEnvironment } from '../../files/assetKinds';
import { placeAsset, useAsEnvironment } from '../../files/placeAsset';
import { canMove, duplicateMaterial, giveMaterial, moveAssets } from '../../model/assetEdits';
import { canRename } from '../../model/assetNames';
import { usagesOf } from '../../model/assetUsages';
import { instancesOf } from '../../model/prefabEdits';
import { addScriptComponent } from '../../model/scriptEdits';
import { duplicateAndShow } from '../scripts/scriptActions';
import { removeEntries, renameEntry } from './assetDialogs';

/** The assets that a context menu acts on: all selected ones when the clicked asset is among them. */
const chosenWith = ({ document }: EditorApi, { name }: AssetEntry): readonly string[] =>
  document.assetSelection.has(name) ? document.assetSelection.items : [name];

function materialEntries(editor: EditorApi, { name, label }: AssetEntry): MenuEntry[] {
  const { document, commands } = editor;
  const users = document.selectedObjects.flatMap((object) => object.getComponent(ObjectRenderer) ?? []);
  const entries: MenuEntry[] = [
    {
      label: t('Give to the selected objects'),
      icon: 'check',
      disabled: users.length === 0,
      run: () =>
        editor.attempt(() =>
          commands.run(giveMaterial(users, name, t('Gave {name} to the selection', { name: label }))),
        ),
    },
  ];
  if (document.assets.materialAsset(name)) {
    const duplicate = (): void => {
      const made = duplicateMaterial(document.scene, name);
      commands.run(made.command);
      document.assetSelection.set([made.name]);
    };
    entries.push({ label: t('Duplicate'), icon: 'duplicate', run: () => editor.attempt(duplicate) });
  }
  return entries;
}

/** Menu entries of a script: open it, add it to the selection. */
export function scriptEntries(editor: EditorApi, name: string): MenuCommand[] {
  const { document, commands } = editor;
  return [
    { label: t('Edit ## the text of a script'), icon: 'code', run: () => editor.openScript(name) },
    {
      label: t('Add to the selected objects'),
      icon: 'add',
      disabled: document.selectedObjects.length === 0,
      run: () => editor.attempt(() => commands.run(addScriptComponent(document.scene, document.selectedObjects, name))),
    },
  ];
}

/** Menu entries of a surface: open it, give it to the selection. */
export function surfaceEntries(editor: EditorApi, name: string): MenuCommand[] {
  const { document, commands } = editor;
  const users = document.selectedObjects.filter(
    (object) => object.getComponent(ObjectRenderer) ?? object.getComponent(ModelRenderer),
  );
  const wear = async (): Promise<void> => {
    const { surfaceWearers, wearSurface } = await import('../../model/surfaceEdits');
    commands.run(wearSurface(name, surfaceWearers(users)));
  };
  return [
    { label: t('Edit ## the text of a script'), icon: 'code', run: () => editor.openMicroShader(`surface:${name}`) },
    {
      label: t('Give to the selected objects'),
      icon: 'check',
      disabled: users.length === 0,
      run: () => editor.attempt(wear),
    },
  ];
}

/** Selects the objects that use an asset, or the instances of a prefab. */
function selectUsers({ document }: EditorApi, { kind, name, label }: AssetEntry): void {
  const { scene } = document;
  const ids =
    kind === 'prefab'
      ? instancesOf(scene, name).map(({ id }) => id)
      : usagesOf(scene, name).flatMap(({ object }) => object ?? []);
  if (ids.length === 0) throw new Error(t('No object uses {name}.', { name: label }));
  document.selection.set(ids);
}

function moveEntries(editor: EditorApi, entry: AssetEntry, folders: readonly string[]): MenuEntry[] {
  const { document, commands } = editor;
  const names = chosenWith(editor, entry).filter((name) => canMove(document.scene, name));
  const folderOf = (name: string): string => assetEntry(document.scene, name)?.folder ?? '';
  const targets = ['', ...folders].filter((folder) => names.some((name) => folderOf(name) !== folder));
  if (names.length === 0 || targets.length === 0) return [];
  const entries = targets.map((folder): MenuEntry => ({
    label: folder || t('The top'),
    icon: 'folder',
    run: () => editor.attempt(() => commands.run(moveAssets(document.scene, names, folder))),
  }));
  return [{ label: t('Move to'), icon: 'folder', entries }];
}

/** Context menu of a card. @param folders - paths of all folders */
export function assetMenu(editor: EditorApi, entry: AssetEntry, folders: readonly string[]): MenuEntry[] {
  const { document } = editor;
  const { kind, name } = entry;
  const attempt = (run: () => unknown) => (): void => editor.attempt(run);
  const entries: MenuEntry[] = [];
  if (kind === 'texture') {
    const run = attempt(async () => {
      await document.assets.load(name);
      useAsEnvironment(editor, name);
    });
    const help = t('Lights all surfaces, and is the background.');
    entries.push({ label: t('Use as environment'), icon: 'world', help, run });
  }
  if (kind === 'material') entries.push(...materialEntries(editor, entry));
  if (kind === 'script') {
    const run = attempt(() => duplicateAndShow(editor, name));
    entries.push(...scriptEntries(editor, name), { label: t('Duplicate'), icon: 'duplicate', run });
  }
  if (kind === 'surface') entries.push(...surfaceEntries(editor, name));
  else if (kind !== 'script' && kind !== 'bake' && (kind !== 'texture' || !isEnvironment(name))) {
    const label = kind === 'material' || kind === 'shader' ? t('Place on a sphere') : t('Place in scene');
    entries.push({ label, icon: 'add', run: attempt(() => placeAsset(editor, entry)) });
  }
  if (kind === 'model') {
    const help = t('Each mesh, light and camera becomes an object that can be edited, each material an asset.');
    const run = attempt(async () => {
      const { placeUnpacked } = await import('../../files/placeUnpacked');
      await placeUnpacked(editor, name);
    });
    entries.push({ label: t('Place unpacked'), icon: 'tree', help, run });
  }
  if (kind === 'prefab') {
    const help = t('Stores it with all that it uses, for every scene in this browser.');
    const run = attempt(async () => (await import('../../files/library/ownLibrary')).keepInLibrary(editor, name));
    entries.push({ label: t('Put into the library'), icon: 'lamp', help, run });
  }
  const label = kind === 'prefab' ? t('Select instances') : t('Select what uses it');
  entries.push({ label, icon: 'select', run: attempt(() => selectUsers(editor, entry)) });
  if (kind === 'prefab' || canRename(document.assets, name)) {
    entries.push({ label: t('Rename…'), keys: 'F2', run: attempt(() => renameEntry(editor, entry)) });
  }
  entries.push(...moveEntries(editor, entry, folders));
  entries.push('separator', {
    label: t('Delete…'),
    icon: 'remove',
    keys: 'Delete',
    disabled: entry.isBuiltin || document.assets.modelOf(name) !== null,
    run: attempt(() => {
      const names = new Set(chosenWith(editor, entry));
      const all = assetEntries(document.scene).filter((each) => names.has(each.name));
      return removeEntries(editor, names.size > 1 ? all : [entry]);
    }),
  });
  return entries;
}
