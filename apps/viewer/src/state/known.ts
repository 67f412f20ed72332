import { scenes } from '@farol/engine/scenes';
import { techniques, views } from '@farol/renderer';
import { type EffectName, effects } from '@farol/renderer/effects';
import { dragonUrls } from '../dragonUrls';
import type { KnownNames } from './ViewerState';

/** Names that the address may hold, and the state of an address without parameters. */
export const known: KnownNames = {
  scenes,
  techniques: Object.keys(techniques),
  views,
  dragons: Object.keys(dragonUrls),
  antialiasing: ['none', ...Object.keys(effects).filter((name) => effects[name as EffectName].group !== null)],
  defaults: {
    ...{ scene: 'temple', technique: 'auto', view: 'final', parameters: {}, dragon: 'medium', aa: 'none' },
    ...{ ao: false, oit: false, decals: false, particles: 0, rectangles: 0 },
    ...{ time: null, width: null, height: null, dpr: null, gui: true },
  },
};
