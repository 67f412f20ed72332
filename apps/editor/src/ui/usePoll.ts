import { useEffect, useState } from 'react';

/**
 * Reads a value several times per second, and renders the component when it changes.
 * @param perSecond - readings per second; 0 reads only while rendering
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
