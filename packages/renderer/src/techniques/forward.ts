import { multipassCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Multipass forward rendering: ambient and emissive light once, then one additive pass for each light over the objects in its
 * range.
 * @see thesis 2.2.2 and 3.2.3.1
 */
export const forward: Technique = {
  label: 'Forward, multipass',
  help: 'An additive pass for each light over the objects it reaches.',
  lightOrder: 'by-volume',
  needsFloatTargets: true,
  fills: 'every-pixel',
  lazy: multipassCode,
  passes: () => multipassCode.required.forwardPasses(),
};
