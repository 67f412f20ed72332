import { ForwardPass } from '../passes/forward/ForwardPass';
import type { Pass, Resource } from '../frame/Pass';
import type { LightLoop } from '../materials/LightLoop';

/**
 * Passes that end every technique: the opaque items it has not drawn, then what transmits, then what is transparent,
 * back to front, each lit by all the lights that the loop gives it.
 * @param loop - microshader that loops over the lights
 * @param behind - the loop of what transmits or is transparent, where lists hold opaque depths alone; default `loop`
 */
export function forwardTail(loop: LightLoop, reads: readonly Resource[] = [], behind = loop): Pass[] {
  return [
    new ForwardPass({ name: 'opaque', list: 'opaque', loop, loopOutside: behind, reads }),
    new ForwardPass({ name: 'transmissive', list: 'transmissive', loop: behind, reads }),
    new ForwardPass({ name: 'transparent', list: 'transparent', loop: behind, reads }),
  ];
}
