import { play } from './play';
import { runScripts } from './runScripts';

/** Available to scripts of the page as `FarolPlayer.ready`; fulfilled when the scene is completely drawn. */
export const ready = play(runScripts);
