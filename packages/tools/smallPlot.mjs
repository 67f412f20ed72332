/** A function that says what was left out. @param {string} name */
const missing = (name) =>
  `export function ${name}() { throw new Error('Built without ${name} of Observable Plot: see smallPlot.mjs'); }`;

/**
 * Parts of Observable Plot that every chart carries along and none of the Lab's uses, each as a module that does what
 * the part does where nobody asks for it: maps, legends, schemes of colours, tips, geometry on spheres, times of day.
 *
 * @type {Readonly<Record<string, string>>} source by path below Plot's `src`, or package
 */
const parts = {
  'projection.js': `
    import { valueObject } from './channel.js';
    import { coerceNumbers } from './options.js';
    export const createProjection = () => undefined;
    export const hasProjection = () => false;
    export const projectionAspectRatio = () => undefined;
    ${['project', 'getGeometryChannels', 'xyProjection'].map(missing).join('\n')}
    export function applyPosition({ x, y }, scales) {
      const position = valueObject({ ...(x && { x }), ...(y && { y }) }, scales);
      if (x) position.x = coerceNumbers(position.x);
      if (y) position.y = coerceNumbers(position.y);
      return position;
    }`,
  'legends.js': `
    export const createLegends = () => [];
    export const exposeLegends = () => legend;
    ${missing('legend')}`,
  'scales/schemes.js': `
    export const isCategoricalScheme = () => false;
    export const isDivergingScheme = () => false;
    ${['ordinalScheme', 'ordinalRange', 'quantitativeScheme', 'maybeBooleanRange'].map(missing).join('\n')}`,
  'marks/tip.js': `
    export class Tip {}
    ${missing('tip')}`,
  'interactions/pointer.js': ['pointer', 'pointerX', 'pointerY', 'anchorX', 'anchorY'].map(missing).join('\n'),
  'd3-geo': ['geoPath', 'geoGraticule10', 'geoCentroid'].map(missing).join('\n'),
  'd3-time-format': ['timeFormat', 'utcFormat'].map(missing).join('\n'),
};

/**
 * Vite plugin: builds Observable Plot without {@link parts}. What is served while one develops is the whole Plot.
 *
 * @returns {import('vite').Plugin}
 */
export function smallPlot() {
  return {
    name: 'farol-small-plot',
    apply: 'build',
    enforce: 'pre',
    load(id) {
      const path = /[\\/]@observablehq[\\/]plot[\\/]src[\\/](.+)$/.exec(id)?.[1].replaceAll('\\', '/');
      const library = /[\\/]node_modules[\\/](d3-[\w-]+)[\\/]/.exec(id)?.[1];
      return parts[path ?? library ?? ''] ?? null;
    },
  };
}
