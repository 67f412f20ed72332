import { useCallback, useState } from 'react';

/**
 * Whether an element is narrower than a width, followed while it is there.
 * @param width - CSS pixels
 * @returns what the element takes as its `ref`, and whether it is narrow
 */
export function useIsNarrow(width: number): readonly [ref: (element: HTMLElement | null) => void, isNarrow: boolean] {
  const [isNarrow, setNarrow] = useState(false);
  const ref = useCallback(
    (element: HTMLElement | null) => {
      if (!element) return undefined;
      const observer = new ResizeObserver(([entry]) => setNarrow(entry.contentRect.width < width));
      observer.observe(element);
      return () => observer.disconnect();
    },
    [width],
  );
  return [ref, isNarrow];
}
