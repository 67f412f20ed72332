/** Longest time (ms) that loops of scripts may take without the page getting its turn. */
export const LOOP_LIMIT = 2000;

/** Number of microtasks with a loop, in a row without a task of the page, that count as an endless loop. */
const TURNS = 100;

/** Time at which scripts began to run in this task of the page (ms); 0 until a loop asks. */
let since = 0;
/** Since when the page had no pause (ms); 0 when no loop has asked since. */
let begun = 0;
/** Turns since then that loops have asked in. */
let turns = 0;

function turnEnded(): void {
  since = 0;
  turns++;
}

function paused(): void {
  begun = turns = 0;
}

let channel: MessageChannel | null = null;

/** Calls `paused` once the page gets its turn: promises that go on by themselves do not give it one. */
function askForPause(): void {
  if (!channel) {
    channel = new MessageChannel();
    channel.port1.addEventListener('message', paused);
    channel.port1.start();
    // in Node a port would keep the process
    for (const port of [channel.port1, channel.port2]) (port as { unref?: () => void }).unref?.();
  }
  channel.port2.postMessage(null);
}

/** Called by loops of scripts now and then. @throws Error when scripts have run for `LOOP_LIMIT` without a pause */
export function loopCheck(): void {
  const now = performance.now();
  if (begun === 0) {
    begun = now;
    askForPause();
  }
  if (since === 0) {
    since = now;
    // runs once the code that the page called has come to its end
    queueMicrotask(turnEnded);
  }
  const isStuck = turns > TURNS && now - begun > LOOP_LIMIT;
  if (!isStuck && now - since <= LOOP_LIMIT) return;
  throw new Error(`A loop has gone on for ${LOOP_LIMIT / 1000} s: give it an end, or do its work over several frames.`);
}
