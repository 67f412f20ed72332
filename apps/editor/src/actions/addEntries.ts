import { t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addObject } from '../model/edits';
import { type Creation, creations } from '../model/creations';
import { type IconName, iconPaths } from '../style/iconPaths';
import type { MenuEntry } from '../api/MenuEntry';

/** Adds something to the scene. @param parent - what it goes below; the top of the tree when null */
export function addCreation(editor: EditorApi, creation: Creation, parent: GameObject | null): void {
  const { document, viewport, commands } = editor;
  const object = creation.make();
  // a child begins where its parent is; others in the middle of the picture
  if (!parent) object.transform.position = viewport.editorCamera.target.toArray();
  commands.run(addObject(document.scene, object, parent ?? document.scene, document.selection.ids));
}

const iconOf = (kind: string): IconName => (kind in iconPaths ? (kind as IconName) : 'object');

/** The lines of the Add menu. @param parent - what the new object goes below; the top of the tree when null */
export function addEntries(editor: EditorApi, parent: GameObject | null = null): MenuEntry[] {
  const all = creations(editor.document.scene);
  const entries = (group: Creation['group'], folder: string | null = null): MenuEntry[] =>
    all
      .filter((creation) => creation.group === group && creation.folder === folder)
      .map((creation) => ({
        label: creation.label,
        icon: iconOf(creation.kind),
        run: () => editor.attempt(() => addCreation(editor, creation, parent)),
      }));
  const folders = [...new Set(all.flatMap(({ folder }) => folder ?? []))];
  const parts = folders.map((folder): MenuEntry => ({ label: folder, entries: entries('mesh', folder) }));
  const meshes = entries('mesh');
  return [
    ...entries('object'),
    ...entries('camera'),
    'separator',
    { label: t('Mesh'), icon: 'mesh', entries: parts.length > 0 ? [...meshes, 'separator', ...parts] : meshes },
    { label: t('Light'), icon: 'point', entries: entries('light') },
  ];
}
