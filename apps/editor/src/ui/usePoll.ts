import { useEffect, useState } from 'react';

/**
 * Reads a value several times a second, and renders when it differs.
 * @param perSecond - 0 reads it once, at each rendering
 */
export function usePoll<T extends string | number | null>(read: () => T, perSecond: number): T {
  const [, setValue] = useState<T>(read);
  useEffect(() => {
    if (perSecond === 0) return;
    const timer = setInterval(() => setValue(read()), 1000 / perSecond);
    return () => clearInterval(timer);
  }, [read, perSecond]);
  return read();
}
