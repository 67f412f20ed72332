import type { TreeInstance } from '@headless-tree/core';
import { useEffect, useRef } from 'react';

/** Keeps the focus in a tree when the row that has it goes, by a deletion or by a move: keys go on. */
export function useKeptFocus(tree: TreeInstance<string>): void {
  const wasInside = useRef(false);
  useEffect(() => {
    const focused = (event: FocusEvent): void => {
      wasInside.current = event.target instanceof Element && event.target.closest('[role="tree"]') !== null;
    };
    // a click on what takes no focus leaves the tree too
    const pressed = (event: PointerEvent): void => {
      wasInside.current &&= event.target instanceof Element && event.target.closest('.hierarchy, .popup') !== null;
    };
    document.addEventListener('focusin', focused);
    document.addEventListener('pointerdown', pressed);
    return () => {
      document.removeEventListener('focusin', focused);
      document.removeEventListener('pointerdown', pressed);
    };
  }, []);
  // after each rendering: rows go in one that comes after that of the edit
  useEffect(() => {
    if (!wasInside.current) return;
    const frame = requestAnimationFrame(() => {
      if (document.activeElement === document.body && tree.getItems().length > 0) tree.updateDomFocus();
    });
    return () => cancelAnimationFrame(frame);
  });
}
