import door from './scripts/Door.ts?raw';
import flicker from './scripts/Flicker.ts?raw';
import follow from './scripts/Follow.ts?raw';
import patrol from './scripts/Patrol.ts?raw';

/** Texts of the library's scripts, by the types of components that they define. */
export const libraryScripts: Readonly<Record<string, string>> = {
  Door: door,
  Flicker: flicker,
  Follow: follow,
  Patrol: patrol,
};
