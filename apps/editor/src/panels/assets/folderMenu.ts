import { t } from '@farol/editing';
import { renderersOf } from '../../actions/materials';
import type { EditorApi } from '../../api/EditorApi';
import type { MenuEntry } from '../../api/MenuEntry';
import { addFolder, addMaterial, removeFolder, renameFolder } from '../../model/assetEdits';
import { joinName, splitName } from '../../model/assetNames';
import { libraryScripts } from '../../model/library/scripts';
import { newScript } from '../../files/newScript';
import { chooseFiles } from './chooseFiles';

/** Adds a material to a folder, gives it to the selected objects, and selects it. */
function newMaterial(editor: EditorApi, folder: string): void {
  const { document, commands } = editor;
  const path = joinName(folder, t('Material'));
  const { command, name } = addMaterial(document.scene, path, { kind: 'physical' }, renderersOf(editor));
  commands.run(command);
  document.assetSelection.set([name]);
}

/** Adds a surface to a folder, and opens its text. */
async function newSurface(editor: EditorApi, folder: string): Promise<void> {
  const [{ builtinSurfaces }, { addSurface }] = await Promise.all([
    import('../../model/surfaces/builtinSurfaces'),
    import('../../model/surfaceEdits'),
  ]);
  const { document, commands } = editor;
  const made = addSurface(document.scene, joinName(folder, t('Surface')), builtinSurfaces.plain.source, {}, []);
  commands.run(made.command);
  document.assetSelection.set([made.surface]);
  editor.openMicroShader(`surface:${made.surface}`);
}

/** Asks for the name of a new folder. */
function newFolder({ document, commands, dialogs }: EditorApi, folder: string): void {
  void dialogs.show({
    kind: 'text',
    title: t('New folder'),
    label: t('Name of the folder'),
    value: t('Folder'),
    action: t('Add'),
    accept: (name) => commands.run(addFolder(document.scene, joinName(folder, name))),
  });
}

export function renameFolderAsked({ document, commands, dialogs }: EditorApi, path: string): void {
  const { folder, leaf } = splitName(path);
  void dialogs.show({
    kind: 'text',
    title: t('Rename {name}', { name: leaf }),
    label: t('Name of the folder'),
    value: leaf,
    action: t('Rename'),
    accept: (name) => {
      if (name !== leaf) commands.run(renameFolder(document.scene, path, joinName(folder, name)));
    },
  });
}

export function removeFolderAsked({ document, commands }: EditorApi, path: string): void {
  commands.run(removeFolder(document.scene, path));
}

/** Entries that add a script that begins with the text of one of the library's scripts. */
export const templateEntries = (editor: EditorApi, folder: string): MenuEntry[] =>
  Object.entries(libraryScripts).map(([type, source]) => ({
    label: t(type),
    icon: 'code',
    run: () => editor.attempt(() => newScript(editor, joinName(folder, type), [], { type, source })),
  }));

/** Menu entries for adding things to a folder. */
export function newEntries(editor: EditorApi, folder: string): MenuEntry[] {
  const attempt = (run: () => unknown) => (): void => editor.attempt(run);
  return [
    { label: t('New material'), icon: 'contrast', run: attempt(() => newMaterial(editor, folder)) },
    { label: t('New surface'), icon: 'code', run: attempt(() => newSurface(editor, folder)) },
    { label: t('New script'), icon: 'code', run: attempt(() => newScript(editor, joinName(folder, t('Script')))) },
    { label: t('Script from a template'), icon: 'code', entries: templateEntries(editor, folder) },
    { label: t('New folder…'), icon: 'folder', run: attempt(() => newFolder(editor, folder)) },
    'separator',
    { label: t('Import…'), icon: 'open', run: attempt(() => chooseFiles(editor)) },
  ];
}

export function folderMenu(editor: EditorApi, path: string, open: (folder: string) => void): MenuEntry[] {
  const attempt = (run: () => unknown) => (): void => editor.attempt(run);
  return [
    { label: t('Open'), icon: 'folder', run: () => open(path) },
    { label: t('Rename…'), keys: 'F2', run: attempt(() => renameFolderAsked(editor, path)) },
    'separator',
    { label: t('Delete'), icon: 'remove', keys: 'Delete', run: attempt(() => removeFolderAsked(editor, path)) },
  ];
}
