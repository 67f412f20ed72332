/**
 * Runs another worker, whose address is this one's name, with a clock that stands still. Its global `live` has the exports
 * of a live module. The first message brings the port by which the page asks.
 */
import type { LiveModule } from '../LiveModule';
import { drawBoth } from './drawBoth';
import { runStill } from './runStill';
import { StillClock } from './StillClock';

const held = self as unknown as { name: string; live?: LiveModule };
const clock = new StillClock();
/** Messages that have come before the other worker listens. */
const early: unknown[] = [];

function hold(event: MessageEvent): void {
  event.stopImmediatePropagation();
  if (event.data instanceof MessagePort) listen(event.data);
  else early.push(event.data);
}

function listen(port: MessagePort): void {
  port.addEventListener('message', async ({ data }) => {
    try {
      port.postMessage({ result: await answer(data.name, data.values) });
    } catch (error) {
      port.postMessage({ error: String(error) });
    }
  });
  port.start();
}

async function answer(name: 'run' | 'drawBoth', values: [number, number]): Promise<unknown> {
  await isRunning;
  const { live } = held;
  if (live === undefined) throw new Error(`${held.name} has no global \`live\`.`);
  return name === 'run' ? runStill(clock, live, ...values) : drawBoth(clock, live, ...values);
}

addEventListener('message', hold);
const isRunning = import(/* @vite-ignore */ held.name).then(() => {
  removeEventListener('message', hold);
  for (const data of early) dispatchEvent(new MessageEvent('message', { data }));
});
