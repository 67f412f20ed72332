/** Duration of work before yielding to the page (ms). */
const SLICE = 12;

let began = 0;

const channel = new MessageChannel();

const nextTask = (): Promise<void> =>
  new Promise((resolve) => {
    channel.port1.addEventListener('message', () => resolve(), { once: true });
    channel.port1.start();
    channel.port2.postMessage(null);
  });

/** Yields to the page when work has lasted for `SLICE` (ms); awaited between small pieces of work. */
export async function breathe(): Promise<void> {
  const now = performance.now();
  if (now - began < SLICE) return;
  await nextTask();
  began = performance.now();
}
