import type { Dialogs, WorkProgress } from '../model/Dialogs';

/** Duration of work after which a progress dialog opens (ms). */
const LONG = 1000;

/**
 * Runs work with a progress dialog that can cancel it. It opens after a second, or at once when progress is known.
 * @param run - gets a signal that is aborted when the user cancels
 * @throws AbortError (as a rejection) when cancelled, else the error of the work
 */
export async function withProgress<T>(
  dialogs: Dialogs,
  title: string,
  run: (signal: AbortSignal) => Promise<T>,
  progress?: WorkProgress,
): Promise<T> {
  const control = new AbortController();
  const request = { kind: 'progress', title, progress } as const;
  let isDone = false;
  let timer: ReturnType<typeof setTimeout>;
  const tell = (): void => {
    // another open dialog has precedence
    if (dialogs.current) {
      timer = setTimeout(tell, LONG);
      return;
    }
    void dialogs.show(request).then(() => {
      if (!isDone) control.abort();
    });
  };
  timer = setTimeout(tell, progress ? 0 : LONG);
  try {
    return await run(control.signal);
  } finally {
    isDone = true;
    clearTimeout(timer);
    if (dialogs.current === request) dialogs.close(false);
  }
}
