import type { Pass } from '../../frame/Pass';
import { forwardTail } from '../forwardTail';
import { AccumulatedOutputPass } from './AccumulatedOutputPass';
import * as chunks from './chunks';
import { MultipassLightsPass } from './MultipassLightsPass';

/** GLSL texts of the microshaders of 'forward', by name. */
export const microShaders = { ...chunks };

/** The passes of 'forward'. */
export function forwardPasses(): Pass[] {
  return [new MultipassLightsPass(), new AccumulatedOutputPass(), ...forwardTail('lightLoopAll')];
}
