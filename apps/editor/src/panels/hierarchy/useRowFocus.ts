import type { FeatureImplementation, TreeInstance } from '@headless-tree/core';
import { useEffect, useRef } from 'react';

/** `rowFocus` in the tree's data: whether the focused item's row gets the focus once it is rendered. */
const isAsked = (tree: TreeInstance<string>): { rowFocus?: boolean } =>
  tree.getDataRef<{ rowFocus?: boolean }>().current;

/** Focuses the row of the tree's focused item, or the first row when that item no longer exists. */
function focusRow(tree: TreeInstance<string>): void {
  if (tree.getItems().length === 0) return;
  if (tree.getFocusedItem().getItemMeta().index < 0) tree.getItems()[0].setFocused();
  const element = tree.getFocusedItem().getElement();
  isAsked(tree).rowFocus = !element;
  element?.focus();
}

/**
 * Focuses the row of the tree's focused item at once, or as soon as it is rendered. The library's own feature uses
 * timers, and focuses the first row when rendering takes long.
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

/** Keeps the focus in the tree when the focused row is removed or moved, so that keys still work. */
export function useRowFocus(tree: TreeInstance<string>): void {
  const isInside = useRef(false);
  useEffect(() => {
    const focused = (event: FocusEvent): void => {
      isInside.current = event.target instanceof Element && event.target.closest('[role="tree"]') !== null;
      isAsked(tree).rowFocus = false;
    };
    // a click on an element that cannot be focused leaves the tree too
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
  // this effect runs after each rendering, since rows change one rendering after the edit
  useEffect(() => {
    const isLost = isInside.current && document.activeElement === document.body;
    if (isLost || isAsked(tree).rowFocus) focusRow(tree);
  });
}
