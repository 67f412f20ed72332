import { DeferredOutputPass } from '../passes/output/DeferredOutputPass';
import { GBufferPass } from '../passes/gbuffer/GBufferPass';
import { LightVolumesPass } from './light-volumes/LightVolumesPass';
import { forwardTail } from './forwardTail';
import type { Technique } from '../frame/Technique';

/**
 * Deferred shading: surfaces are drawn into a G-buffer once, then each light is drawn over the pixels of its volume.
 * @see Deering et al. 1988; Hargreaves and Harris 2004; thesis 2.2.3.3.1 and 3.2.3.2
 */
export const deferred: Technique = {
  label: 'Deferred shading',
  help: 'Surfaces into a G-buffer, then each light over the pixels of its volume.',
  lightOrder: 'by-volume',
  needsFloatTargets: true,
  fills: 'every-pixel',
  passes: () => [new GBufferPass(), new LightVolumesPass(), new DeferredOutputPass(), ...forwardTail('lightLoopAll')],
};
