import { techniques, views } from '@farol/renderer';
import { scenes } from '@farol/scenes';
import { antialiasingNames, effectParameters } from './effectParameters';
import type { KnownNames } from './ViewerState';

/** Names that are valid in the address, and the state of an address without parameters. */
export const known: KnownNames = {
  scenes,
  techniques: Object.keys(techniques),
  views,
  qualities: ['auto', 'full', 'lite'],
  antialiasing: antialiasingNames,
  budgets: ['auto', 'on', 'off'],
  effects: effectParameters,
  defaults: {
    ...{ scene: 'temple', technique: 'auto', view: 'final', parameters: {}, aa: 'none' },
    ...{ effects: {}, quality: 'auto', decals: false, particles: 0, rectangles: 0 },
    ...{ time: null, width: null, height: null, dpr: null, budget: 'auto', gui: true },
  },
};
