import { t } from '@farol/editing';
import { Fragment, type ReactNode, useEffect, useMemo, useRef, useState } from 'react';
import { setDraggedAsset } from '../../files/dragAsset';
import { dropOn } from '../../files/dropOn';
import { type LibraryItem, libraryItems } from '../../files/library/libraryItems';
import {
  itemsOfFolder,
  keptItems,
  libraryChanged,
  openLibraryFolder,
  type OwnItem,
  removeFromLibrary,
} from '../../files/library/ownLibrary';
import { placeLibraryItem } from '../../files/library/placeLibraryItem';
import { Button } from '../../ui/Button';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';
import { SearchInput } from '../../ui/SearchInput';
import { SelectBox, type SelectOption } from '../../ui/SelectBox';
import { watchFinger } from './watchFinger';
import '../assets/assets.css';
import './library.css';

type Filter = LibraryItem['group'] | 'all';

const groups = (): SelectOption<Filter>[] => [
  { value: 'all', label: t('Everything') },
  { value: 'lamp', label: t('Lamps') },
  { value: 'prop', label: t('Props') },
  { value: 'play', label: t('Behaviour') },
  { value: 'sky', label: t('Skies') },
  { value: 'material', label: t('Materials') },
  { value: 'own', label: t('My own') },
  { value: 'folder', label: t('Opened folder') },
];

/** Whether the name or a tag of an item contains every word of a search. */
function matches({ label, tags }: LibraryItem, search: string): boolean {
  const text = [label, ...tags].join(' ').toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/**
 * Card of an item: dragged into the scene by mouse, or by finger after a long press; added at the centre of the view by
 * a click, a tap or Enter.
 */
function LibraryCard({ item }: { readonly item: LibraryItem }): ReactNode {
  const editor = useEditor();
  const card = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    const asset = { kind: 'library', name: item.id } as const;
    return watchFinger(card.current!, ({ x, y }) => {
      if (document.elementFromPoint(x, y)?.closest('.viewport-place') == null) return;
      editor.attempt(() => dropOn(editor, { asset, files: new Map() }, { kind: 'picture', x, y }));
    });
  }, [editor, item.id]);
  return (
    <>
      <button
        ref={card}
        type="button"
        className="asset-card"
        title={t('{name}: drag it into the picture, or click to add it', { name: item.label })}
        draggable
        onDragStart={(event) => setDraggedAsset(event.dataTransfer, { kind: 'library', name: item.id })}
        onClick={() => editor.attempt(() => placeLibraryItem(editor, item.id))}
      >
        <span className="asset-picture">
          {item.picture === null ? (
            <Icon name="prefab" size={28} />
          ) : (
            <img src={item.picture} alt="" draggable={false} />
          )}
        </span>
        <span className="asset-name one-line">{item.label}</span>
      </button>
      {item.group === 'own' && (
        <IconButton
          icon="remove"
          className="button small library-remove"
          label={t('Remove {name} from the library', { name: item.label })}
          onClick={() => editor.attempt(() => removeFromLibrary(item.id))}
        />
      )}
    </>
  );
}

/** Prefabs in the user's library, and those of the opened folder, with URLs of their pictures. */
function useOwnItems(): readonly LibraryItem[] {
  const [items, setItems] = useState<readonly LibraryItem[]>([]);
  useEffect(() => {
    let addresses: string[] = [];
    let readings = 0;
    const show = (group: 'own' | 'folder', list: readonly OwnItem[]): LibraryItem[] =>
      list.map(({ id, name, tags, picture }) => {
        const address = picture && URL.createObjectURL(picture);
        if (address) addresses.push(address);
        return { id, label: name, group, tags, picture: address };
      });
    const forget = (): void => {
      for (const address of addresses) URL.revokeObjectURL(address);
      addresses = [];
    };
    const read = async (): Promise<void> => {
      const reading = ++readings;
      const kept = await keptItems();
      if (reading !== readings) return;
      forget();
      setItems([...show('own', kept), ...show('folder', itemsOfFolder())]);
    };
    void read();
    const end = libraryChanged.subscribe(() => void read());
    return () => {
      readings++;
      end();
      forget();
    };
  }, []);
  return items;
}

/** Lamps, props, behaviour, skies and materials to drag into the scene, filtered by group, tags and a search. */
export function LibraryPanel(): ReactNode {
  const [search, setSearch] = useState('');
  const [filter, setFilter] = useState<Filter>('all');
  const [wanted, setTag] = useState('');
  const editor = useEditor();
  const own = useOwnItems();
  const all = useMemo(() => [...libraryItems(), ...own], [own]);
  const inGroup = all.filter(({ group }) => filter === 'all' || group === filter);
  const tags = [...new Set(inGroup.flatMap((item) => item.tags))].toSorted((a, b) => a.localeCompare(b));
  // a tag that the group lacks is ignored
  const tag = tags.includes(wanted) ? wanted : '';
  const items = inGroup.filter((item) => matches(item, search) && (tag === '' || item.tags.includes(tag)));
  // headings are shown unless the list is filtered
  const isWhole = filter === 'all' && tag === '' && search.trim() === '';
  const tagOptions = [{ value: '', label: t('Any tag') }, ...tags.map((value) => ({ value, label: value }))];
  const openFolder = async (): Promise<void> => {
    const { directoryOpen } = await import('browser-fs-access');
    const files = await directoryOpen({ recursive: true });
    await openLibraryFolder(
      editor,
      files.filter((file) => file instanceof File),
    );
    setFilter('folder');
  };
  return (
    <section className="panel assets" aria-label={t('Library')}>
      <div className="assets-bar">
        <SearchInput label={t('Search the library')} placeholder={t('Search')} value={search} onSearch={setSearch} />
        <SelectBox<Filter> value={filter} options={groups()} label={t('Kind of item')} onChange={setFilter} />
        <SelectBox<string> value={tag} options={tagOptions} label={t('Tag')} onChange={setTag} />
        <Button
          icon="open"
          label={t('Open folder…')}
          title={t('Shows the prefabs of all scene files in a folder')}
          onClick={() => editor.attempt(openFolder)}
        />
      </div>
      <div className="assets-body">
        {items.length === 0 && <p className="assets-empty">{t('Nothing matches the search.')}</p>}
        <ul className="assets-grid library-grid">
          {items.map((item, i) => (
            <Fragment key={item.id}>
              {isWhole && item.group !== items[i - 1]?.group && (
                <li className="assets-heading">{groups().find(({ value }) => value === item.group)!.label}</li>
              )}
              <li>
                <LibraryCard item={item} />
              </li>
            </Fragment>
          ))}
        </ul>
      </div>
    </section>
  );
}
