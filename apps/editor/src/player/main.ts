import { play } from './play';

/** Available to scripts of the page as `FarolPlayer.ready`; fulfilled when the scene is completely drawn. */
export const ready = play(null);
