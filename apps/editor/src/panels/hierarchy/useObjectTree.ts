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
import { useEffect, useState } from 'react';
import { canMoveTo, moveObjects, renameObject } from '../../model/edits';
import { childrenOf, type Container } from '../../model/commands/Placement';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { useKeptFocus } from './useKeptFocus';
import { matching, wordsOf } from './matching';

/** Id of what all objects are below; no GameObject has it. */
const ROOT = '/';

/** Pixels that each level is set in by. */
export const INDENT = 14;

type Item = ItemInstance<string>;
type Enabled = (tree: TreeInstance<string>) => boolean;

/** After an arrow key the focused item is the selected one, as in other editors. */
function selectFocused(tree: TreeInstance<string>): void {
  tree.updateDomFocus();
  tree.setSelectedItems([tree.getFocusedItem().getId()]);
}

/** The settings that headless-tree has for the arrow keys. */
const arrow = (
  hotkey: string,
): { hotkey: string; canRepeat: boolean; preventDefault: boolean; isEnabled: Enabled } => ({
  hotkey,
  canRepeat: true,
  preventDefault: true,
  isEnabled: (tree) => !tree.getState().dnd,
});

/**
 * The tree of the document's GameObjects, with selection, renaming, and re-parenting by drag and by keyboard.
 * @param query - when there is one, what matches it, side by side; see `matchesQuery`
 */
export function useObjectTree(scrollTo: (index: number) => void, query: string): TreeInstance<string> {
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

  const tree = useTree<string>({
    instanceBuilder: buildProxiedInstance,
    rootItemId: ROOT,
    indent: INDENT,
    getItemName: (item) => document.scene.findById(item.getId())?.name ?? '',
    // every object can hold others
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
      // F2 is an action of the editor's, wherever the focus is
      renameItem: { hotkey: 'F2', isEnabled: () => false, handler: () => {} },
      // Ctrl+A is one too: everything, folded or not
      selectAll: { hotkey: 'Control+KeyA', isEnabled: () => false, handler: () => {} },
      focusNextItem: {
        ...arrow('ArrowDown'),
        handler: (_, self) => {
          self.focusNextItem();
          selectFocused(self);
        },
      },
      focusPreviousItem: {
        ...arrow('ArrowUp'),
        handler: (_, self) => {
          self.focusPreviousItem();
          selectFocused(self);
        },
      },
    },
    features: [
      syncDataLoaderFeature,
      selectionFeature,
      hotkeysCoreFeature,
      dragAndDropFeature,
      keyboardDragAndDropFeature,
      renamingFeature,
    ],
  });

  useEffect(() => tree.rebuildTree(), [tree, structure, expandedItems, query]);
  useEffect(() => document.opened.subscribe(() => setExpandedItems([])), [document]);

  // what is selected elsewhere, in the picture or by an undo, is shown here
  const primary = document.selection.primary;
  useEffect(() => {
    const above: string[] = [];
    const object = primary === null ? null : document.scene.findById(primary);
    for (let parent = object?.parent; parent; parent = parent.parent) above.push(parent.id);
    setExpandedItems((expanded) => (above.every((id) => expanded.includes(id)) ? expanded : [...expanded, ...above]));
  }, [document, primary]);
  useEffect(() => {
    if (primary === null) return;
    const item = tree.getItems().find((each) => each.getId() === primary);
    if (!item) return;
    item.setFocused();
    scrollTo(item.getItemMeta().index);
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- once for each selection, after its parents were unfolded
  }, [tree, primary, expandedItems]);

  useKeptFocus(tree);

  useEffect(
    () =>
      editor.renameRequested.subscribe(() => {
        const id = document.selection.primary;
        if (id !== null) tree.getItemInstance(id).startRenaming();
      }),
    [editor, document, tree],
  );
  return tree;
}
