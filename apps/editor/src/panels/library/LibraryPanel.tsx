import { t } from '@farol/editing';
import { type ReactNode, useMemo, useState } from 'react';
import { setDraggedAsset } from '../../files/dragAsset';
import { type LibraryItem, libraryItems } from '../../files/library/libraryItems';
import { placeLibraryItem } from '../../files/library/placeLibraryItem';
import type { LibraryGroup } from '../../model/library/names';
import { useEditor } from '../../ui/EditorContext';
import { SearchInput } from '../../ui/SearchInput';
import { SelectBox, type SelectOption } from '../../ui/SelectBox';
import '../assets/assets.css';

type Filter = LibraryGroup | 'all';

const groups = (): SelectOption<Filter>[] => [
  { value: 'all', label: t('Everything') },
  { value: 'lamp', label: t('Lamps') },
  { value: 'prop', label: t('Props') },
];

/** Whether the name or a tag of an item contains every word of a search. */
function matches({ label, tags }: LibraryItem, search: string): boolean {
  const text = [label, ...tags].join(' ').toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/** Card of an item: dragged into the scene, or added at the middle of the view by a click, a tap or Enter. */
function LibraryCard({ item }: { readonly item: LibraryItem }): ReactNode {
  const editor = useEditor();
  return (
    <button
      type="button"
      className="asset-card"
      title={t('{name}: drag it into the picture, or click to add it', { name: item.label })}
      draggable
      onDragStart={(event) => setDraggedAsset(event.dataTransfer, { kind: 'library', name: item.id })}
      onClick={() => editor.attempt(() => placeLibraryItem(editor, item.id))}
    >
      <span className="asset-picture">
        <img src={item.picture} alt="" draggable={false} />
      </span>
      <span className="asset-name">{item.label}</span>
    </button>
  );
}

/** Lamps and props to drag into the scene, found by group, tags and a search. */
export function LibraryPanel(): ReactNode {
  const [search, setSearch] = useState('');
  const [filter, setFilter] = useState<Filter>('all');
  const [wanted, setTag] = useState('');
  const all = useMemo(() => libraryItems(), []);
  const inGroup = all.filter(({ group }) => filter === 'all' || group === filter);
  const tags = [...new Set(inGroup.flatMap((item) => item.tags))].toSorted((a, b) => a.localeCompare(b));
  // a tag that the group lacks filters nothing
  const tag = tags.includes(wanted) ? wanted : '';
  const items = inGroup.filter((item) => matches(item, search) && (tag === '' || item.tags.includes(tag)));
  const tagOptions = [{ value: '', label: t('Any tag') }, ...tags.map((value) => ({ value, label: value }))];
  return (
    <section className="panel assets" aria-label={t('Library')}>
      <div className="assets-bar">
        <SearchInput label={t('Search the library')} placeholder={t('Search')} value={search} onSearch={setSearch} />
        <SelectBox<Filter> value={filter} options={groups()} label={t('Kind of item')} onChange={setFilter} />
        <SelectBox<string> value={tag} options={tagOptions} label={t('Tag')} onChange={setTag} />
      </div>
      <div className="assets-body">
        {items.length === 0 && <p className="assets-empty">{t('Nothing of that name.')}</p>}
        <ul className="assets-grid">
          {items.map((item) => (
            <li key={item.id}>
              <LibraryCard item={item} />
            </li>
          ))}
        </ul>
      </div>
    </section>
  );
}
