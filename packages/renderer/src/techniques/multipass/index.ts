import type { Pass } from '../../frame/Pass';
import { forwardTail } from '../forwardTail';
import { AccumulatedOutputPass } from './AccumulatedOutputPass';
import * as chunks from './chunks';
import { MultipassLightsPass } from './MultipassLightsPass';

/** Sources of its microshaders, by name. */
export const microShaders = { ...chunks };

/** The passes of 'forward'. */
export function forwardPasses(): Pass[] {
  return [new MultipassLightsPass(), new AccumulatedOutputPass(), ...forwardTail('lightLoopAll')];
}
