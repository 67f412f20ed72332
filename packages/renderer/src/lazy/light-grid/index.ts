import { GBufferPass } from '../../gbuffer/GBufferPass';
import type { Pass } from '../../frame/Pass';
import { addBuiltinMicroShaders } from '../../builtinMicroShaders';
import { lightLoopClustered, lightTiles, tiledOutput } from '../../lighting/lists/chunks';
import { LightGridPass } from '../../lighting/lists/LightGridPass';
import { TiledOutputPass } from '../../lighting/lists/TiledOutputPass';
import { forwardTail } from '../../techniques/forwardTail';

export { rankByGrid } from '../../lighting/lists/rankByGrid';

addBuiltinMicroShaders({ lightLoopClustered, lightTiles, tiledOutput });

/** The passes of 'clustered-forward'. */
export function clusteredForwardPasses(): Pass[] {
  return [new LightGridPass(), ...forwardTail('lightLoopClustered', ['light-lists'])];
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
