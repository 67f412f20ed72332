import { type BothPictures, drawBoth } from './drawBoth';
import { StillClock } from './StillClock';
import { runStill } from './runStill';
import { askWorker, holdWorkers } from './holdWorkers';

/** The page's module, run by steps. */
export interface Still {
  /** Draws so many frames, each a step (s) after the one before, once all code of the module is there. */
  run(step: number, frames: number): Promise<void>;
  /** Draws the module's scene by stock three and by Farol. */
  drawBoth(width: number, height: number): Promise<BothPictures>;
}

/** Holds the clocks of the page and of the workers that it makes from now on. */
export async function holdStill(): Promise<Still> {
  const clock = new StillClock();
  await holdWorkers();
  return {
    async run(...steps) {
      const live = await window.live;
      await (live.worker ? askWorker(live.worker, 'run', steps) : runStill(clock, live, ...steps));
    },
    async drawBoth(...size) {
      const live = await window.live;
      return live.worker ? askWorker(live.worker, 'drawBoth', size) : drawBoth(clock, live, ...size);
    },
  };
}
