/** Longest time (ms) that loops of scripts may run before the page must process other tasks. */
export const LOOP_LIMIT = 2000;

/** Number of consecutive microtasks with loops, without another task of the page, that count as an endless loop. */
const TURNS = 100;

/** Start (ms) of scripts in the current microtask; 0 until a loop calls `loopCheck`. */
let since = 0;
/** Time (ms) of the first `loopCheck` since the page's last other task; 0 for none. */
let begun = 0;
/** Number of microtasks that called `loopCheck` since `begun`. */
let turns = 0;

function turnEnded(): void {
  since = 0;
  turns++;
}

function paused(): void {
  begun = turns = 0;
}

let channel: MessageChannel | null = null;

/** Calls `paused` in the next task of the page; chained promises (microtasks) run before that. */
function askForPause(): void {
  if (!channel) {
    channel = new MessageChannel();
    channel.port1.addEventListener('message', paused);
    channel.port1.start();
    // in Node an open port would keep the process alive
    for (const port of [channel.port1, channel.port2]) (port as { unref?: () => void }).unref?.();
  }
  channel.port2.postMessage(null);
}

/** Called by loops of scripts at intervals. @throws Error when scripts have run for `LOOP_LIMIT` without a pause */
export function loopCheck(): void {
  const now = performance.now();
  if (begun === 0) {
    begun = now;
    askForPause();
  }
  if (since === 0) {
    since = now;
    // runs when the current call stack is empty
    queueMicrotask(turnEnded);
  }
  const isStuck = turns > TURNS && now - begun > LOOP_LIMIT;
  if (!isStuck && now - since <= LOOP_LIMIT) return;
  throw new Error(`A loop has gone on for ${LOOP_LIMIT / 1000} s: give it an end, or do its work over several frames.`);
}
