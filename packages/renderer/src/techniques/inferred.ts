import { lightBufferCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Inferred lighting: light pre-pass with both buffers at a fraction of the resolution (`FarolRenderer.inferredScale`, a half by
 * default), joined to the materials at full resolution by a filter that takes light only from texels of the same object,
 * depth and normal. Transparent objects are lit by the same buffers: each layer has one texel of each 2 × 2. Limits, at a
 * scale of a half:
 * - Light that changes within two pixels (fine normal maps, small highlights, hard edges of light) is smoothed.
 * - A transparent layer has a sample of light every four pixels, in place of the surface behind it. Up to three
 *   overlapping layers are lit right; with more, farther ones take the light of the most similar texel nearby.
 * - Objects or parts smaller than two pixels may have no sample, and take that of the most similar texel nearby.
 * - Objects are told apart by number, up to 2,047 in a frame; two objects with the same number only by depth and normal.
 * @see Kircher and Lawrance 2009, Inferred Lighting: Fast dynamic lighting and shadows for opaque and translucent objects,
 *   https://doi.org/10.1145/1581073.1581080; thesis 2.2.3.3.3
 */
export const inferred: Technique = {
  label: 'Inferred lighting',
  help: 'Light pre-pass at half the resolution, joined by a filter that keeps edges.',
  lightOrder: 'by-volume',
  needsFloatTargets: true,
  lazy: lightBufferCode,
  passes: () => lightBufferCode.required.inferredPasses(),
};
