import { Lazy } from '../frame/Lazy';

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new Lazy('light-buffer', () => import('./light-buffer'), 'other techniques draw');

/** Light lists of clusters: clustered forward and clustered deferred shading. */
export const gridCode = new Lazy('light-grid', () => import('./light-lists/clusteredPasses'), 'other techniques draw');

/** Light lists of tiles: Forward+, tiled forward and tiled deferred shading. */
export const tileCode = new Lazy('light-tiles', () => import('./light-lists/tiledPasses'), 'other techniques draw');

/** Multipass lighting: the technique 'forward'. */
export const multipassCode = new Lazy('multipass', () => import('./multipass'), 'other techniques draw');
