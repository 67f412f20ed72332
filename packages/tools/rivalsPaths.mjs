import { join } from 'node:path';
import { root } from './root.mjs';

/** Folder of the engines that the Lab measures beside Farol: no workspace, so that `npm ci` leaves them out. */
export const rivalsFolder = join(root, 'apps/lab/rivals');

/** Their modules, and `versions.json`. */
export const rivalsDist = join(rivalsFolder, 'dist');

/** Packages by competitor's key. */
export const rivalPackages = { playcanvas: 'playcanvas', babylon: '@babylonjs/core' };
