import { t, tCount } from '@farol/editing';
import { ContextMenu } from '@base-ui/react/context-menu';
import { Fragment, type KeyboardEvent, type ReactNode, useCallback, useMemo, useRef, useState } from 'react';
import { type AssetEntry, assetEntries, type AssetKind, kindLabel } from '../../files/assetKinds';
import { isFileDrag } from '../../files/dragAsset';
import { placeAsset } from '../../files/placeAsset';
import { foldersOf } from '../../model/assetEdits';
import { splitName } from '../../model/assetNames';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { LateSoundButton } from '../../ui/lateAssetParts';
import { LateItems, MenuButton } from '../../ui/MenuButton';
import { SelectBox, type SelectOption } from '../../ui/SelectBox';
import { SearchInput } from '../../ui/SearchInput';
import { AssetCard } from './AssetCard';
import { assetMenu } from './assetMenu';
import { chooseFiles } from './chooseFiles';
import { folderMenu, newEntries, removeFolderAsked, renameFolderAsked } from './folderMenu';
import { FolderBar } from './FolderBar';
import { FolderTarget } from './FolderTarget';
import { removeEntries, renameEntry } from './assetDialogs';
import './assets.css';
import { Button } from '../../ui/Button';

type Filter = AssetKind | 'all' | 'own';

const kinds: readonly AssetKind[] = [
  'prefab',
  'model',
  'mesh',
  'texture',
  'material',
  'surface',
  'script',
  'clip',
  'sound',
  'profile',
  'bake',
];

const filters = (): SelectOption<Filter>[] => [
  { value: 'all', label: t('Everything') },
  { value: 'own', label: t('Imported') },
  ...kinds.map((kind): SelectOption<Filter> => ({ value: kind, label: kindLabel(kind, true) })),
];

interface Category {
  readonly title: string;
  readonly entries: readonly AssetEntry[];
}

/** Assets under headings: the scene's own, with parts right after their model; then those that come with Farol, by kind. */
function categories(entries: readonly AssetEntry[]): Category[] {
  const own = entries.filter(({ isBuiltin }) => !isBuiltin);
  const withParts = own.flatMap((entry) =>
    entry.model !== null ? [] : [entry, ...own.filter(({ model }) => model === entry.name)],
  );
  const lost = own.filter((entry) => !withParts.includes(entry));
  return [
    { title: t('Of this scene'), entries: [...withParts, ...lost] },
    ...kinds.map((kind) => ({
      title: kindLabel(kind, true),
      entries: entries.filter((entry) => entry.isBuiltin && entry.kind === kind),
    })),
  ].filter((category) => category.entries.length > 0);
}

function countBy(names: readonly string[]): Map<string, number> {
  const counts = new Map<string, number>();
  for (const name of names) counts.set(name, (counts.get(name) ?? 0) + 1);
  return counts;
}

/** Whether a name contains every word of a search. */
const matches = (label: string, search: string): boolean =>
  search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => label.toLowerCase().includes(word));

/** Target of a context menu: a card, a folder, or empty space. */
interface Pressed {
  readonly entry: AssetEntry | null;
  readonly folder: string | null;
}

/** Browser of assets and prefabs in folders; files dropped on it are imported. */
export function AssetsPanel(): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  const { assetSelection } = document;
  const revision = useSignal(document.assetsChanged) + useSignal(document.prefabs);
  useSignal(document.opened);
  useSignal(assetSelection.changed);
  const [search, setSearch] = useState('');
  const [filter, setFilter] = useState<Filter>('all');
  const [wanted, setFolder] = useState('');
  const [unfolded, setUnfolded] = useState<ReadonlySet<string>>(new Set());
  const unfold = (model: string): void =>
    setUnfolded(
      (before) => new Set(before.has(model) ? [...before].filter((each) => each !== model) : [...before, model]),
    );
  const [isOver, setIsOver] = useState(false);
  const pressed = useRef<Pressed>({ entry: null, folder: null });
  // oxlint-disable-next-line react-hooks/exhaustive-deps -- the revision changes with the library and the prefabs
  const all = useMemo(() => assetEntries(document.scene), [document, document.scene, revision]);
  // oxlint-disable-next-line react-hooks/exhaustive-deps -- the revision changes with both
  const folders = useMemo(() => foldersOf(document.scene), [document.scene, revision]);
  // when the shown folder was removed, the top folder is shown
  const folder = folders.includes(wanted) ? wanted : '';
  const isFlat = search.trim() !== '';
  const fits = (entry: AssetEntry): boolean =>
    filter === 'all' || (filter === 'own' ? !entry.isBuiltin : entry.kind === filter);
  const entries = all.filter(
    (entry) =>
      fits(entry) &&
      (isFlat
        ? matches(`${entry.folder} ${entry.label} ${entry.name}`, search)
        : entry.folder === folder && !entry.isVariant),
  );
  const isUnsorted = isFlat || (filter !== 'all' && filter !== 'own');
  /** Number of parts of each model; parts are hidden until their model's card is unfolded. */
  const parts = useMemo(
    () => countBy(all.flatMap(({ model, isVariant }) => (model && !isVariant ? [model] : []))),
    [all],
  );
  const shown = isUnsorted ? entries : entries.filter(({ model }) => model === null || unfolded.has(model));
  const groups = isUnsorted ? [{ title: '', entries: shown }] : categories(shown);
  const below = isFlat ? [] : folders.filter((path) => splitName(path).folder === folder);

  /** Remembers the card under the pointer: a context menu opened by a long press does not report it. */
  const note = (event: { target: EventTarget }): void => {
    const element = event.target as HTMLElement;
    const name = element.closest<HTMLElement>('[data-asset]')?.dataset.asset;
    pressed.current = {
      entry: entries.find((entry) => entry.name === name) ?? null,
      folder: element.closest<HTMLElement>('.asset-folder')?.dataset.folder ?? null,
    };
  };

  const select = useCallback(
    (entry: AssetEntry, isAdded: boolean): void => {
      if (isAdded) assetSelection.toggle(entry.name);
      else assetSelection.set([entry.name]);
    },
    [assetSelection],
  );
  const place = useCallback((entry: AssetEntry): void => editor.attempt(() => placeAsset(editor, entry)), [editor]);

  const press = (event: KeyboardEvent): void => {
    if (event.key !== 'Delete' && event.key !== 'F2') return;
    const target = (event.target as HTMLElement).closest<HTMLElement>('.asset-folder')?.dataset.folder;
    const chosen = entries.filter(({ name }) => assetSelection.has(name));
    if (target === undefined && chosen.length === 0) return;
    event.preventDefault();
    event.stopPropagation();
    editor.attempt(() => {
      if (target !== undefined) (event.key === 'F2' ? renameFolderAsked : removeFolderAsked)(editor, target);
      else if (event.key === 'Delete') return removeEntries(editor, chosen);
      else renameEntry(editor, chosen.at(-1)!);
    });
  };

  return (
    <section className="panel assets" aria-label={t('Assets')}>
      <div className="assets-bar">
        <SearchInput label={t('Search assets')} placeholder={t('Search assets')} value={search} onSearch={setSearch} />
        <SelectBox<Filter> value={filter} options={filters()} label={t('Kind of asset')} onChange={setFilter} />
        <MenuButton label={t('New')} icon="add" className="button framed" entries={() => newEntries(editor, folder)} />
        <Button icon="open" label={t('Import…')} onClick={() => editor.attempt(() => chooseFiles(editor))} />
      </div>
      {(folder !== '' || below.length > 0) && <FolderBar folder={folder} onOpen={setFolder} />}
      <ContextMenu.Root>
        <ContextMenu.Trigger
          className="assets-body"
          data-drop={isOver}
          onDragOver={(event) => setIsOver(isFileDrag(event.dataTransfer))}
          onDragLeave={() => setIsOver(false)}
          onDrop={() => setIsOver(false)}
          onPointerDown={note}
          onContextMenu={note}
          onKeyDown={press}
        >
          {shown.length + below.length === 0 && (
            <p className="assets-empty">
              {isFlat ? t('Nothing matches the search.') : t('Nothing here yet. Drop files here to import them.')}
            </p>
          )}
          <ul className="assets-grid">
            {below.map((path) => (
              <li key={`folder/${path}`}>
                <FolderTarget folder={path} className="asset-card asset-folder" onOpen={setFolder}>
                  <span className="asset-picture">
                    <Icon name="folder" size={28} />
                  </span>
                  <span className="asset-name one-line">{splitName(path).leaf}</span>
                </FolderTarget>
              </li>
            ))}
            {groups.map(({ title, entries: grouped }) => (
              <Fragment key={title}>
                {groups.length > 1 && <li className="assets-heading">{title}</li>}
                {grouped.map((entry) => (
                  <li key={`${entry.kind}/${entry.name}`} data-part={entry.model !== null}>
                    <AssetCard
                      entry={entry}
                      selected={assetSelection.has(entry.name)}
                      dragged={assetSelection.items}
                      onSelect={select}
                      onPlace={place}
                    />
                    {entry.kind === 'sound' && <LateSoundButton name={entry.name} />}
                    {!isUnsorted && parts.has(entry.name) && (
                      <button
                        type="button"
                        className="asset-parts"
                        aria-expanded={unfolded.has(entry.name)}
                        title={t('Parts of {name}', { name: entry.label })}
                        onClick={() => unfold(entry.name)}
                      >
                        <span className="fold" data-open={unfolded.has(entry.name)}>
                          <Icon name="chevron" size={8} />
                        </span>
                        {tCount(parts.get(entry.name)!, '{count} part', '{count} parts')}
                      </button>
                    )}
                  </li>
                ))}
              </Fragment>
            ))}
          </ul>
        </ContextMenu.Trigger>
        <ContextMenu.Portal>
          <ContextMenu.Positioner className="positioner">
            <ContextMenu.Popup className="popup">
              <LateItems
                entries={() => {
                  const { entry, folder: path } = pressed.current;
                  if (entry) return assetMenu(editor, entry, folders);
                  return path === null ? newEntries(editor, folder) : folderMenu(editor, path, setFolder);
                }}
              />
            </ContextMenu.Popup>
          </ContextMenu.Positioner>
        </ContextMenu.Portal>
      </ContextMenu.Root>
    </section>
  );
}
