import { forwardTail } from './forwardTail';
import type { Technique } from '../frame/Technique';

/**
 * Forward rendering with all lights looped in one shader, without culling.
 * @see thesis 2.2.1.3, several lights per shader
 */
export const forwardSinglePass: Technique = {
  label: 'Forward, single pass',
  help: 'Each object once, by a loop over all lights.',
  lightOrder: 'by-volume',
  needsFloatTargets: false,
  readsFew: true,
  // null: three clears, by one call; a full-screen draw of the background takes six and a change of program
  fills: null,
  passes: () => forwardTail('lightLoopAll', [], 'lightLoopAll', true),
};
