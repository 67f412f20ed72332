/**
 * What is being made, or a rejection as soon as the signal is aborted.
 * @param giveBack - gets what is made all the same after that
 */
export function cancellable<T>(
  making: Promise<T>,
  signal: AbortSignal | undefined,
  giveBack: (late: T) => void,
): Promise<T> {
  if (!signal) return making;
  return new Promise((resolve, reject) => {
    const cancel = (): void => {
      reject(signal.reason as Error);
      making.then(giveBack, () => {});
    };
    if (signal.aborted) return cancel();
    signal.addEventListener('abort', cancel, { once: true });
    making.then(resolve, reject).finally(() => signal.removeEventListener('abort', cancel));
  });
}
