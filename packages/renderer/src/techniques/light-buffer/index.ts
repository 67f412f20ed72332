import type { Pass } from '../../frame/Pass';
import { forwardTail } from '../forwardTail';
import * as chunks from './chunks';
import { LightBufferPass } from './LightBufferPass';
import { LitMaterialsPass } from './LitMaterialsPass';
import { StippledPass } from './StippledPass';
import { ThinGBufferPass } from './ThinGBufferPass';

/** GLSL texts of the microshaders of 'light-prepass', by name. */
export const microShaders = { ...chunks };

/** The passes of 'light-prepass'. */
export function lightPrepassPasses(): Pass[] {
  return [
    new ThinGBufferPass({ scaled: false, stipple: false }),
    new LightBufferPass(),
    new LitMaterialsPass(),
    ...forwardTail('lightLoopAll'),
  ];
}

/** The passes of 'inferred'. */
export function inferredPasses(): Pass[] {
  const [opaque, transmissive] = forwardTail('lightLoopAll');
  return [
    new ThinGBufferPass({ scaled: true, stipple: true }),
    new LightBufferPass(),
    new LitMaterialsPass(),
    opaque,
    transmissive,
    new StippledPass('lightLoopAll'),
  ];
}
