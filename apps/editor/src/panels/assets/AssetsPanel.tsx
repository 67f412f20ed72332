import { t } from '@farol/editing';
import { ContextMenu } from '@base-ui/react/context-menu';
import { fileOpen } from 'browser-fs-access';
import { type ReactNode, useMemo, useRef, useState } from 'react';
import { type AssetEntry, assetEntries, type AssetKind } from '../../files/assetKinds';
import { isFileDrag } from '../../files/dragAsset';
import { importFiles } from '../../files/importFiles';
import { placeAsset } from '../../files/placeAsset';
import { ThumbnailMaker } from '../../files/ThumbnailMaker';
import type { EditorApi } from '../../api/EditorApi';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { LateItems } from '../../ui/MenuButton';
import { SelectBox, type SelectOption } from '../../ui/SelectBox';
import { AssetCard } from './AssetCard';
import { assetMenu, removeEntry, renameEntry } from './assetMenu';
import './assets.css';

type Filter = AssetKind | 'all' | 'own';

const filters = (): SelectOption<Filter>[] => [
  { value: 'all', label: t('Everything') },
  { value: 'own', label: t('Imported') },
  { value: 'prefab', label: t('Prefabs') },
  { value: 'model', label: t('Models') },
  { value: 'mesh', label: t('Meshes') },
  { value: 'texture', label: t('Textures') },
  { value: 'material', label: t('Materials') },
];

const makers = new WeakMap<EditorApi, ThumbnailMaker>();

function makerOf(editor: EditorApi): ThumbnailMaker {
  let maker = makers.get(editor);
  if (!maker) makers.set(editor, (maker = new ThumbnailMaker(editor.viewport)));
  return maker;
}

const endings = [
  '.glb',
  '.gltf',
  '.bin',
  '.obj',
  '.mtl',
  '.zip',
  '.tga',
  '.bmp',
  '.png',
  '.jpg',
  '.jpeg',
  '.webp',
  '.hdr',
  '.exr',
  '.ply',
  '.gz',
  '.ktx2',
];

async function choose(editor: EditorApi): Promise<void> {
  const files = await fileOpen({
    description: t('Models, textures, environments'),
    extensions: endings,
    multiple: true,
  });
  await importFiles(editor, new Map(files.map((file) => [file.name, file])));
}

/** Whether every word of a search is in a name. */
const matches = (label: string, search: string): boolean =>
  search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => label.toLowerCase().includes(word));

/** Everything that can be placed or assigned; files that are dropped on it are imported. */
export function AssetsPanel(): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  const revision = useSignal(document.assetsChanged) + useSignal(document.prefabs);
  useSignal(document.opened);
  const [search, setSearch] = useState('');
  const [filter, setFilter] = useState<Filter>('all');
  const [selected, setSelected] = useState<string | null>(null);
  const [isOver, setIsOver] = useState(false);
  const pressed = useRef<AssetEntry | null>(null);
  const maker = makerOf(editor);
  // oxlint-disable-next-line react-hooks/exhaustive-deps -- the revision stands for the library and the prefabs
  const all = useMemo(() => assetEntries(document.scene), [document, document.scene, revision]);
  const entries = all.filter(
    (entry) =>
      (filter === 'all' || (filter === 'own' ? !entry.isBuiltin : entry.kind === filter)) &&
      matches(entry.label, search),
  );

  /** Notes the card that a menu would be of: a long press of a finger opens one without telling where. */
  const note = (event: { target: EventTarget }): void => {
    const card = (event.target as HTMLElement).closest<HTMLElement>('[data-asset]');
    pressed.current = entries.find(({ name }) => name === card?.dataset.asset) ?? null;
  };

  return (
    <section className="panel assets" aria-label={t('Assets')}>
      <div className="assets-bar">
        <input
          className="input"
          type="search"
          value={search}
          placeholder={t('Search assets')}
          aria-label={t('Search assets')}
          onChange={(event) => setSearch(event.target.value)}
        />
        <SelectBox<Filter> value={filter} options={filters()} label={t('Kind of asset')} onChange={setFilter} />
        <button type="button" className="button framed" onClick={() => editor.attempt(() => choose(editor))}>
          <Icon name="open" />
          <span>{t('Import…')}</span>
        </button>
      </div>
      <ContextMenu.Root>
        <ContextMenu.Trigger
          className="assets-body"
          data-drop={isOver}
          onDragOver={(event) => setIsOver(isFileDrag(event.dataTransfer))}
          onDragLeave={() => setIsOver(false)}
          onDrop={() => setIsOver(false)}
          onPointerDown={note}
          onContextMenu={note}
          onKeyDown={(event) => {
            const entry = entries.find(({ name }) => name === selected);
            const act = { Delete: removeEntry, F2: renameEntry }[event.key];
            if (!act || !entry) return;
            event.preventDefault();
            event.stopPropagation();
            editor.attempt(() => act(editor, entry));
          }}
        >
          {entries.length === 0 && (
            <p className="assets-empty">{t('Nothing of that name. Drop files here to import them.')}</p>
          )}
          <ul className="assets-grid">
            {entries.map((entry) => (
              <li key={`${entry.kind}/${entry.name}`}>
                <AssetCard
                  entry={entry}
                  maker={maker}
                  selected={entry.name === selected}
                  onSelect={() => setSelected(entry.name)}
                  onPlace={() => editor.attempt(() => placeAsset(editor, entry))}
                />
              </li>
            ))}
          </ul>
        </ContextMenu.Trigger>
        <ContextMenu.Portal>
          <ContextMenu.Positioner className="positioner">
            <ContextMenu.Popup className="popup">
              <LateItems
                entries={() =>
                  pressed.current
                    ? assetMenu(editor, pressed.current)
                    : [{ label: t('Import…'), icon: 'open', run: () => editor.attempt(() => choose(editor)) }]
                }
              />
            </ContextMenu.Popup>
          </ContextMenu.Positioner>
        </ContextMenu.Portal>
      </ContextMenu.Root>
    </section>
  );
}
