import {
  buildProxiedInstance,
  dragAndDropFeature,
  type DragTarget,
  hotkeysCoreFeature,
  isOrderedDragTarget,
  type ItemInstance,
  keyboardDragAndDropFeature,
  renamingFeature,
  selectionFeature,
  syncDataLoaderFeature,
  type TreeInstance,
} from '@headless-tree/core';
import { useTree } from '@headless-tree/react';
import { useEffect, useRef, useState } from 'react';
import { canMoveTo, moveObjects, renameObject } from '../../model/edits';
import { childrenOf, type Container } from '../../model/commands/Placement';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { matching, wordsOf } from './matching';
import { rowFocusFeature, useRowFocus } from './useRowFocus';

/** Id of the tree's hidden root; no GameObject has it. */
const ROOT = '/';

/** Indentation per level (CSS pixels). */
export const INDENT = 14;

type Item = ItemInstance<string>;
type Enabled = (tree: TreeInstance<string>) => boolean;
type Handler = (event: KeyboardEvent, tree: TreeInstance<string>) => void;

/** State and actions of the hierarchy's tree. */
export interface ObjectTree {
  readonly tree: TreeInstance<string>;
  /** The visible rows, in order. */
  readonly rows: readonly Item[];
  /** Selects one row, which becomes the start of ranges. */
  select(item: Item): void;
  /** Selects the range up to a row, which becomes the primary selection. */
  selectTo(item: Item): void;
  /** Adds a row to the selection or removes it; the row becomes the start of ranges. */
  toggle(item: Item): void;
}

/** A key that moves the focus. @param to - gives the row to focus, from all rows and the focused one */
const rowKey = (
  hotkey: string,
  to: (rows: readonly Item[], focused: number) => Item | undefined,
  select: (item: Item) => void,
): { hotkey: string; canRepeat: boolean; preventDefault: boolean; isEnabled: Enabled; handler: Handler } => ({
  hotkey,
  canRepeat: true,
  preventDefault: true,
  isEnabled: (tree) => !tree.getState().dnd,
  handler: (_, tree) => {
    const rows = tree.getItems();
    const item = to(
      rows,
      rows.findIndex((each) => each.isFocused()),
    );
    if (!item) return;
    item.setFocused();
    tree.updateDomFocus();
    select(item);
  },
});

const first = (rows: readonly Item[]): Item | undefined => rows.at(0);
const last = (rows: readonly Item[]): Item | undefined => rows.at(-1);
const below = (rows: readonly Item[], focused: number): Item | undefined => rows[focused + 1];
const above = (rows: readonly Item[], focused: number): Item | undefined => rows[focused - 1];

/**
 * The tree of the document's GameObjects, with selection, renaming, and re-parenting by drag and by keyboard.
 * @param query - search; when it is not empty, matching objects are listed without nesting
 */
export function useObjectTree(scrollTo: (index: number) => void, query: string): ObjectTree {
  const editor = useEditor();
  const { document } = editor;
  const structure = useSignal(document.structure);
  useSignal(document.selection.changed);
  const [expandedItems, setExpandedItems] = useState<string[]>([]);
  const { ids } = document.selection;
  const words = wordsOf(query);

  const containerOf = (id: string): Container => (id === ROOT ? document.scene : document.scene.findById(id)!);
  const childIds = (id: string): string[] => {
    if (words.length > 0) return id === ROOT ? matching(document.scene, words) : [];
    const container = id === ROOT ? document.scene : document.scene.findById(id);
    return container ? childrenOf(container).map((child) => child.id) : [];
  };
  const objectsOf = (items: readonly Item[]): NonNullable<ReturnType<typeof document.scene.findById>>[] =>
    items.flatMap((item) => document.scene.findById(item.getId()) ?? []);

  const anchor = useRef<string | null>(null);
  const select = (item: Item): void => {
    anchor.current = item.getId();
    document.selection.set([item.getId()]);
  };
  const selectTo = (item: Item): void => {
    const { selection } = document;
    // an object selected elsewhere, such as in the viewport, starts a range too
    const begin = anchor.current !== null && selection.has(anchor.current) ? anchor.current : selection.primary;
    const items = tree.getItems();
    const from = items.findIndex((each) => each.getId() === begin);
    if (from < 0) return select(item);
    anchor.current = begin;
    const to = item.getItemMeta().index;
    const range = items.slice(Math.min(from, to), Math.max(from, to) + 1).map((each) => each.getId());
    selection.set([...range.filter((id) => id !== item.getId()), item.getId()]);
  };
  const toggle = (item: Item): void => {
    anchor.current = item.getId();
    document.selection.toggle(item.getId());
  };

  /** A key that selects all objects found by the search. */
  const selectFound = (hotkey: string): ReturnType<typeof rowKey> => ({
    hotkey,
    canRepeat: false,
    preventDefault: true,
    isEnabled: () => words.length > 0,
    handler: (_, tree) => {
      const found = objectsOf(tree.getItems()).filter((object) => !object.lockedInHierarchy);
      document.selection.set(found.map(({ id }) => id));
    },
  });

  const tree = useTree<string>({
    instanceBuilder: buildProxiedInstance,
    rootItemId: ROOT,
    indent: INDENT,
    getItemName: (item) => document.scene.findById(item.getId())?.name ?? '',
    // every object can have children
    isItemFolder: () => true,
    dataLoader: { getItem: (id) => id, getChildren: childIds },
    state: { selectedItems: ids as string[], expandedItems },
    setSelectedItems: (next) => document.selection.set(typeof next === 'function' ? next(ids as string[]) : next),
    setExpandedItems,
    scrollToItem: (item) => scrollTo(item.getItemMeta().index),
    canReorder: true,
    canDrop: (items, target) => words.length === 0 && canMoveTo(objectsOf(items), containerOf(target.item.getId())),
    onDrop: (items: Item[], target: DragTarget<string>) => {
      const parent = target.item.getId();
      const index = isOrderedDragTarget(target) ? target.insertionIndex : undefined;
      editor.attempt(() =>
        editor.commands.run(moveObjects(document.scene, objectsOf(items), containerOf(parent), index)),
      );
      setExpandedItems((expanded) => (expanded.includes(parent) ? expanded : [...expanded, parent]));
    },
    onRename: (item, name) => {
      const object = document.scene.findById(item.getId());
      if (object && name.trim()) editor.commands.run(renameObject(object, name.trim()));
    },
    hotkeys: {
      // F2 is an action of the editor, available with focus anywhere
      renameItem: { hotkey: 'F2', isEnabled: () => false, handler: () => {} },
      // Enter is handled by the field, which ignores it while an input method composes text
      completeRenaming: { hotkey: 'Enter', isEnabled: () => false, handler: () => {} },
      abortRenaming: { hotkey: 'Escape', isEnabled: () => false, handler: () => {} },
      // without a search Ctrl+A is an action of the editor: it selects everything, folded or not
      selectAll: selectFound('Control+KeyA'),
      customSelectAll: selectFound('Meta+KeyA'),
      focusNextItem: rowKey('ArrowDown', below, select),
      focusPreviousItem: rowKey('ArrowUp', above, select),
      focusFirstItem: rowKey('Home', first, select),
      focusLastItem: rowKey('End', last, select),
      selectDownwards: rowKey('Shift+ArrowDown', below, selectTo),
      selectUpwards: rowKey('Shift+ArrowUp', above, selectTo),
      customSelectToFirst: rowKey('Shift+Home', first, selectTo),
      customSelectToLast: rowKey('Shift+End', last, selectTo),
    },
    features: [
      syncDataLoaderFeature,
      selectionFeature,
      hotkeysCoreFeature,
      dragAndDropFeature,
      keyboardDragAndDropFeature,
      renamingFeature,
      rowFocusFeature,
    ],
  });

  useEffect(() => tree.rebuildTree(), [tree, structure, expandedItems, query]);
  useEffect(() => document.opened.subscribe(() => setExpandedItems([])), [document]);

  // the tree scrolls to objects selected elsewhere, as in the viewport or by undo
  const primary = document.selection.primary;
  useEffect(() => {
    const above: string[] = [];
    const object = primary === null ? null : document.scene.findById(primary);
    for (let parent = object?.parent; parent; parent = parent.parent) above.push(parent.id);
    setExpandedItems((expanded) => (above.every((id) => expanded.includes(id)) ? expanded : [...expanded, ...above]));
  }, [document, primary]);
  /** Id of an object to scroll to, whose row may be rendered later than the selection changes. */
  const toShow = useRef<string | null>(null);
  const rows = tree.getItems();
  const show = (): void => {
    if (toShow.current === null) return;
    const item = rows.find((each) => each.getId() === toShow.current);
    if (!item) return;
    toShow.current = null;
    item.setFocused();
    scrollTo(item.getItemMeta().index);
  };
  useEffect(() => {
    toShow.current = primary;
    show();
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- once for each selection, after its parents were unfolded
  }, [tree, primary, expandedItems]);
  // oxlint-disable-next-line react-hooks/exhaustive-deps, react/exhaustive-effect-dependencies -- rows may have been rendered
  useEffect(show, [rows]);

  useRowFocus(tree);

  useEffect(
    () =>
      editor.renameRequested.subscribe(() => {
        const id = document.selection.primary;
        if (id !== null) tree.getItemInstance(id).startRenaming();
      }),
    [editor, document, tree],
  );
  return { tree, rows, select, selectTo, toggle };
}
