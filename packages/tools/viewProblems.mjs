import { sourceFiles } from './sourceFiles.mjs';
import { tableOf } from './texts.mjs';

/**
 * The renderer's sentences on what a frame lacks for a view, which apps show in their language.
 *
 * @returns {string[]}
 */
export const viewProblems = () =>
  [...sourceFiles()]
    .filter(([path]) => path.endsWith('renderer/src/views/buffers/problems.ts'))
    .flatMap(([path, source]) => Object.values(tableOf(path, source)));
