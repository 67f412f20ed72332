import { isComposing, t } from '@farol/editing';
import { ContextMenu } from '@base-ui/react/context-menu';
import type { ItemInstance } from '@headless-tree/core';
import { AssistiveTreeDescription } from '@headless-tree/react';
import { useVirtualizer } from '@tanstack/react-virtual';
import {
  type ComponentProps,
  type KeyboardEvent,
  type MouseEvent,
  type ReactNode,
  useCallback,
  useLayoutEffect,
  useRef,
  useState,
} from 'react';
import { addEntries } from '../../actions/addEntries';
import { paste } from '../../actions/clipboard';
import { objectEntries } from '../../actions/objectEntries';
import { useEditor } from '../../ui/EditorContext';
import { LateItems, MenuButton } from '../../ui/MenuButton';
import { SearchInput } from '../../ui/SearchInput';
import { actionEntry, type MenuEntry } from '../../api/MenuEntry';
import './hierarchy.css';
import { HierarchyRow, rowState } from './HierarchyRow';
import { useObjectTree } from './useObjectTree';

/** Height of a row (CSS pixels), larger for fingers. */
const ROW_HEIGHT = matchMedia('(pointer: coarse)').matches ? 40 : 24;

/** Text for screen readers: the target of objects that are moved by keys, or else how to begin moving them. */
const moveText: ComponentProps<typeof AssistiveTreeDescription>['getLabel'] = (drag) => {
  const target = drag?.dragTarget;
  if (!target) return `${t('Ctrl+Shift+D in the tree')}: ${t('Move objects by the arrow keys; Enter: put them there')}`;
  return t('{names}: place {place} below {parent}', {
    names: (drag.draggedItems ?? []).map((item) => item.getItemName()).join(', '),
    place: 'childIndex' in target ? target.childIndex + 1 : 1,
    parent: target.item.getItemName() || t('Scene'),
  });
};

/** The tree of GameObjects; only visible rows are rendered. */
export function HierarchyPanel(): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  const scroller = useRef<HTMLDivElement>(null);
  const pressed = useRef<string | undefined>(undefined);
  const [query, setQuery] = useState('');
  const { tree, rows, ...selection } = useObjectTree((index) => virtualizer.scrollToIndex(index), query);
  // oxlint-disable-next-line react/incompatible-library -- this component memoises nothing by hand
  const virtualizer = useVirtualizer({
    count: rows.length,
    getScrollElement: () => scroller.current,
    estimateSize: () => ROW_HEIGHT,
    overscan: 8,
  });

  const selecting = useRef(selection);
  useLayoutEffect(() => {
    selecting.current = selection;
  });
  const choose = useCallback(
    (item: ItemInstance<string>, event: MouseEvent): void => {
      item.setFocused();
      tree.updateDomFocus();
      if (event.shiftKey) selecting.current.selectTo(item);
      else if (event.ctrlKey || event.metaKey) selecting.current.toggle(item);
      else selecting.current.select(item);
    },
    [tree],
  );

  /** Remembers the row under the pointer: a context menu opened by a long press does not report it. */
  const note = (event: { target: EventTarget }): void => {
    pressed.current = (event.target as HTMLElement).closest<HTMLElement>('[data-object-id]')?.dataset.objectId;
  };
  /** Selects the row of a context menu, unless it is selected already. */
  const selectPressed = (): void => {
    const id = pressed.current;
    if (id === undefined) document.selection.clear();
    else if (!document.selection.has(id)) document.selection.set([id]);
  };
  const menu = (): readonly MenuEntry[] =>
    objectEntries(editor) ?? [
      { label: t('Add'), icon: 'add', entries: addEntries(editor) },
      actionEntry(paste, editor),
    ];

  const searchKey = (event: KeyboardEvent<HTMLInputElement>): void => {
    if (isComposing(event)) return;
    if (event.key === 'Escape' && query !== '') setQuery('');
    else if (event.key === 'ArrowDown' || event.key === 'Enter') {
      const [first] = tree.getItems();
      if (!first) return;
      document.selection.set([first.getId()]);
      first.setFocused();
      tree.updateDomFocus();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <section className="panel hierarchy" aria-label={t('Hierarchy')}>
      <header className="panel-header">
        <SearchInput
          className="input search"
          value={query}
          label={t('Search objects')}
          title={t('Parts of names and of components, such as: lamp light')}
          autoComplete="off"
          spellCheck={false}
          onSearch={setQuery}
          onKeyDown={searchKey}
        />
        <MenuButton label={t('Add object')} icon="add" iconOnly entries={() => addEntries(editor)} />
      </header>
      <ContextMenu.Root onOpenChange={(open) => open && selectPressed()}>
        <ContextMenu.Trigger
          ref={scroller}
          className="tree-scroller"
          onPointerDown={note}
          onContextMenu={note}
          onClick={(event) => event.target === event.currentTarget && document.selection.clear()}
        >
          <AssistiveTreeDescription tree={tree} getLabel={moveText} />
          <div
            {...tree.getContainerProps(t('GameObjects'))}
            className="tree"
            style={{ height: virtualizer.getTotalSize() }}
          >
            {virtualizer.getVirtualItems().map(({ index, start }) => {
              const item = rows[index];
              const object = item && document.scene.findById(item.getId());
              if (!object) return null;
              return (
                <HierarchyRow
                  key={object.id}
                  tree={tree}
                  item={item}
                  object={object}
                  top={start}
                  height={ROW_HEIGHT}
                  state={rowState(tree, item, object)}
                  onSelect={choose}
                />
              );
            })}
            <div className="drag-line" style={tree.getDragLineStyle()} />
          </div>
          {query.trim() !== '' && rows.length === 0 && <p className="menu-empty">{t('Nothing matches the search.')}</p>}
        </ContextMenu.Trigger>
        <ContextMenu.Portal>
          <ContextMenu.Positioner className="positioner">
            <ContextMenu.Popup className="popup">
              <LateItems entries={menu} />
            </ContextMenu.Popup>
          </ContextMenu.Positioner>
        </ContextMenu.Portal>
      </ContextMenu.Root>
    </section>
  );
}
