import type { LiveModule } from '../LiveModule';
import type { StillClock } from './StillClock';

/** Draws so many frames of a module, each a step (s) after the one before, once all of its code is there. */
export async function runStill(clock: StillClock, live: LiveModule, step: number, frames: number): Promise<void> {
  const farol = await live.farol;
  clock.advance(0.001);
  if (farol) await clock.until(farol.ready);
  if (live.ready) await clock.until(live.ready);
  for (let i = 0; i < frames; i++) clock.advance(step);
  if (farol) await clock.until(farol.ready);
}
