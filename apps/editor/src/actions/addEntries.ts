import { t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addObject } from '../model/edits';
import { type Creation, creations } from '../model/creations';
import { type LibraryGroup, libraryNames } from '../model/library/names';
import { type IconName, iconPaths } from '../style/iconPaths';
import type { MenuEntry } from '../api/MenuEntry';

/** A point of the page (CSS pixels). */
export interface PagePoint {
  readonly x: number;
  readonly y: number;
}

/**
 * Adds an object to the scene.
 * @param parent - parent, at whose origin the object is put; null for the top of the tree, in front of the camera
 * @param at - page position where the object lands; the centre of the viewport when absent
 */
export async function addCreation(
  editor: EditorApi,
  creation: Creation,
  parent: GameObject | null,
  at?: PagePoint,
): Promise<void> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  const object = await creation.make();
  if (scene !== document.scene) return;
  if (!parent) {
    const { landInPicture } = await import('../files/landInPicture');
    await landInPicture(editor, [object], at);
    if (scene !== document.scene) return;
  }
  commands.run(addObject(scene, object, parent ?? scene, selection.ids));
}

/** An item of the library, as the Add menu and the palette offer it. */
interface LibraryEntry {
  readonly id: string;
  readonly label: string;
  /** Name of the group's submenu. */
  readonly folder: string;
  /** Adds the entry's object or component, as `addCreation` does. */
  run(editor: EditorApi, parent?: GameObject | null, at?: PagePoint): Promise<void>;
}

const libraryFolders = (): Readonly<Record<LibraryGroup, string>> => ({
  ...{ lamp: t('Lamps'), prop: t('Props'), play: t('Behaviour'), sky: t('Sky') },
});

export const libraryEntries = (): LibraryEntry[] =>
  (Object.keys(libraryNames) as LibraryGroup[]).flatMap((group) =>
    Object.entries<string>(libraryNames[group]).map(([id, name]) => ({
      id,
      label: t(name),
      folder: libraryFolders()[group],
      async run(editor, parent, at) {
        const { placeLibraryItem } = await import('../files/library/placeLibraryItem');
        await placeLibraryItem(editor, id, { parent: parent ?? undefined, at });
      },
    })),
  );

const iconOf = (name: string): IconName => (name in iconPaths ? (name as IconName) : 'object');

/**
 * Entries of the Add menu.
 * @param parent - parent of the new object; the top of the tree when null
 * @param at - page position where the object lands; the centre of the viewport when absent
 */
export function addEntries(editor: EditorApi, parent: GameObject | null = null, at?: PagePoint): MenuEntry[] {
  const all = creations(editor.document.scene);
  const entries = (group: Creation['group'], folder: string | null = null): MenuEntry[] =>
    all
      .filter((creation) => creation.group === group && creation.folder === folder)
      .map((creation) => ({
        label: creation.label,
        icon: iconOf(creation.icon),
        run: () => editor.attempt(() => addCreation(editor, creation, parent, at)),
      }));
  const meshFolders = all.filter(({ group }) => group === 'mesh').flatMap(({ folder }) => folder ?? []);
  const folders = [...new Set(meshFolders)];
  const parts = folders.map((folder): MenuEntry => ({ label: folder, entries: entries('mesh', folder) }));
  const meshes = entries('mesh');
  const library = libraryEntries();
  const ofLibrary = (folder: string, icon: IconName): MenuEntry => ({
    label: folder,
    icon,
    entries: library
      .filter((each) => each.folder === folder)
      .map(({ label, run }) => ({ label, icon, run: () => editor.attempt(() => run(editor, parent, at)) })),
  });
  return [
    ...entries('object'),
    'separator',
    ...entries('building'),
    { label: t('Mesh'), icon: 'mesh', entries: parts.length > 0 ? [...meshes, 'separator', ...parts] : meshes },
    { label: t('Light'), icon: 'point', entries: entries('light') },
    ofLibrary(t('Lamps'), 'lamp'),
    ofLibrary(t('Props'), 'mesh'),
    ofLibrary(t('Behaviour'), 'trigger'),
    ofLibrary(t('Sky'), 'world'),
    { label: t('Particles'), icon: 'particles', entries: entries('particles', t('Particles')) },
  ];
}
