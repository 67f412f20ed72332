/** Longest time (ms) that loops of scripts may take without the page getting its turn. */
export const LOOP_LIMIT = 2000;

/** Since when scripts run without the page getting its turn (ms); 0 when no loop has asked yet. */
let since = 0;

const ended = (): void => void (since = 0);

/** Called by loops of scripts now and then. @throws Error when scripts have run for `LOOP_LIMIT` without a pause */
export function loopCheck(): void {
  const now = performance.now();
  if (since === 0) {
    since = now;
    // runs once the code that the page called has come to its end
    queueMicrotask(ended);
  } else if (now - since > LOOP_LIMIT) {
    throw new Error(
      `A loop has gone on for ${LOOP_LIMIT / 1000} s: give it an end, or do its work over several frames.`,
    );
  }
}
