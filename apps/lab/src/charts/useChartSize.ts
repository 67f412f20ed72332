import { useEffect, useState } from 'preact/hooks';
import type { RefObject } from 'preact';

/**
 * Width of an element (CSS pixels), and whether it is within 400 pixels of the visible part of the page: charts farther
 * away are drawn once scrolled into view, or printed.
 */
export function useChartSize(element: RefObject<HTMLElement | null>): { width: number; isNear: boolean } {
  const [width, setWidth] = useState(0);
  const [isNear, setNear] = useState(false);
  useEffect(() => {
    const host = element.current!;
    const resized = new ResizeObserver(([entry]) => setWidth(Math.max(240, Math.floor(entry.contentRect.width))));
    const seen = new IntersectionObserver(([entry]) => setNear(entry.isIntersecting), { rootMargin: '400px' });
    const print = (): void => setNear(true);
    resized.observe(host);
    seen.observe(host);
    addEventListener('beforeprint', print);
    return () => {
      resized.disconnect();
      seen.disconnect();
      removeEventListener('beforeprint', print);
    };
  }, [element]);
  return { width, isNear };
}
