import type { Dialogs } from '../model/Dialogs';

/** How long work may take before a dialog tells of it (ms). */
const LONG = 1000;

/**
 * Runs work that may take long: after a second a dialog says what it is, and cancels it.
 * @param run - gets the signal that the user has cancelled it by
 * @throws AbortError (as a rejection) when cancelled, else what the work throws
 */
export async function withProgress<T>(
  dialogs: Dialogs,
  title: string,
  run: (signal: AbortSignal) => Promise<T>,
): Promise<T> {
  const control = new AbortController();
  const request = { kind: 'progress', title } as const;
  let isDone = false;
  let timer: ReturnType<typeof setTimeout>;
  const tell = (): void => {
    // a question that is open comes first
    if (dialogs.current) {
      timer = setTimeout(tell, LONG);
      return;
    }
    void dialogs.show(request).then(() => {
      if (!isDone) control.abort();
    });
  };
  timer = setTimeout(tell, LONG);
  try {
    return await run(control.signal);
  } finally {
    isDone = true;
    clearTimeout(timer);
    if (dialogs.current === request) dialogs.close(false);
  }
}
