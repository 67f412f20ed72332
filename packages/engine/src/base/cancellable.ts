/**
 * Resolves with the result of `making`, or rejects as soon as the signal is aborted.
 * @param giveBack - disposes of a result that arrives after the abort
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
