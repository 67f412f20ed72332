import { ForwardPass } from '../passes/forward/ForwardPass';
import type { Pass, Resource } from '../frame/Pass';
import type { LightLoop } from '../materials/LightLoop';

/**
 * Passes that end every technique: opaque items not drawn yet, then transmissive ones, then transparent ones, back to front,
 * each lit by `loop` or `behind`.
 * @param loop - microshader that loops over the lights
 * @param behind - loop for transmissive and transparent items, which are not covered by light lists culled by opaque depths;
 *   default `loop`
 * @param isFirst - whether no other pass of the technique draws opaque items. Default false
 */
export function forwardTail(loop: LightLoop, reads: readonly Resource[] = [], behind = loop, isFirst = false): Pass[] {
  return [
    new ForwardPass({ name: 'opaque', list: 'opaque', loop, loopOutside: behind, reads, isFirst }),
    new ForwardPass({ name: 'transmissive', list: 'transmissive', loop: behind, reads }),
    new ForwardPass({ name: 'transparent', list: 'transparent', loop: behind, reads }),
  ];
}
