import { join } from 'node:path';
import { root } from './root.mjs';

/** Folder of the engines that the Lab measures beside Farol: no workspace, so that `npm ci` leaves them out. */
export const rivalsFolder = join(root, 'apps/lab/rivals');

/** Folder of the bundled engines, a module each, and of `versions.json`. */
export const rivalsDist = join(rivalsFolder, 'dist');

/** npm packages of the other engines, by key of the Lab's competitor. */
export const rivalPackages = { playcanvas: 'playcanvas', babylon: '@babylonjs/core' };
