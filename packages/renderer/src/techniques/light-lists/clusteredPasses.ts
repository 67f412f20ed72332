import { GBufferPass } from '../../passes/gbuffer/GBufferPass';
import type { Pass } from '../../frame/Pass';
import { addBuiltinMicroShaders } from '../../microshaders/builtinRegistry';
import { addOther, addPoint, lightLoopClustered, lightTiles, tiledOutput } from './chunks';
import { LightGridPass } from './LightGridPass';
import { TiledOutputPass } from './TiledOutputPass';
import { readLightsInRows } from './readLights';
import { forwardTail } from '../forwardTail';

export { rankByGrid } from './rankByGrid';

readLightsInRows();
addBuiltinMicroShaders({ addOther, addPoint, lightLoopClustered, lightTiles, tiledOutput });

/** The passes of 'clustered-forward'. */
export function clusteredForwardPasses(): Pass[] {
  return [new LightGridPass(), ...forwardTail('lightLoopClustered', ['light-lists'], 'lightLoopClustered', true)];
}

/** The passes of 'clustered-deferred'. */
export function clusteredDeferredPasses(): Pass[] {
  return [
    new GBufferPass(),
    new LightGridPass('gbuffer'),
    new TiledOutputPass(),
    ...forwardTail('lightLoopClustered', ['light-lists']),
  ];
}
