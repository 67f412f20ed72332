import { useCallback, useState } from 'react';

/**
 * Whether an element is narrower than a width, kept up to date.
 * @param width - CSS pixels
 * @returns ref callback for the element, and whether it is narrow
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
