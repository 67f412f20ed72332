import { play } from './play';
import { runScripts } from './runScripts';

/** Fulfilled when the scene of the page is drawn as it stays: `FarolPlayer.ready` for other scripts of the page. */
export const ready = play(runScripts);
