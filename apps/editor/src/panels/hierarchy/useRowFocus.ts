import type { FeatureImplementation, TreeInstance } from '@headless-tree/core';
import { useEffect, useRef } from 'react';

/** Whether the row of the tree's focused item is to have the focus once it is rendered. */
const isAsked = (tree: TreeInstance<string>): { rowFocus?: boolean } =>
  tree.getDataRef<{ rowFocus?: boolean }>().current;

/** Gives the focus to the row of the tree's focused item; that of the first one where this item has gone. */
function focusRow(tree: TreeInstance<string>): void {
  if (tree.getItems().length === 0) return;
  if (tree.getFocusedItem().getItemMeta().index < 0) tree.getItems()[0].setFocused();
  const element = tree.getFocusedItem().getElement();
  isAsked(tree).rowFocus = !element;
  element?.focus();
}

/**
 * The focus goes to the row of the tree's focused item at once, or with the rendering that brings this row, however late:
 * the library's own waits for a row by timers, and takes the first row when that takes long.
 */
export const rowFocusFeature: FeatureImplementation<string> = {
  key: 'row-focus',
  treeInstance: {
    updateDomFocus({ tree }) {
      focusRow(tree);
      if (isAsked(tree).rowFocus) tree.getConfig().scrollToItem?.(tree.getFocusedItem());
    },
  },
};

/** Keeps the focus in a tree when the row that has it goes, by a deletion or by a move: keys go on. */
export function useRowFocus(tree: TreeInstance<string>): void {
  const isInside = useRef(false);
  useEffect(() => {
    const focused = (event: FocusEvent): void => {
      isInside.current = event.target instanceof Element && event.target.closest('[role="tree"]') !== null;
      isAsked(tree).rowFocus = false;
    };
    // a click on what takes no focus leaves the tree too
    const pressed = (event: PointerEvent): void => {
      isInside.current &&= event.target instanceof Element && event.target.closest('.hierarchy, .popup') !== null;
    };
    document.addEventListener('focusin', focused);
    document.addEventListener('pointerdown', pressed);
    return () => {
      document.removeEventListener('focusin', focused);
      document.removeEventListener('pointerdown', pressed);
    };
  }, [tree]);
  // after each rendering: rows come and go in one that follows that of the edit
  useEffect(() => {
    const isLost = isInside.current && document.activeElement === document.body;
    if (isLost || isAsked(tree).rowFocus) focusRow(tree);
  });
}
