import { ForwardPass } from '../passes/ForwardPass';
import type { Pass, Resource } from '../passes/Pass';

/**
 * What ends every technique: the opaque items it has not drawn, then what transmits, then what is transparent, back to
 * front, each lit by all the lights that the loop gives it.
 */
export function forwardTail(loop: string, reads: readonly Resource[] = []): Pass[] {
  return (['opaque', 'transmissive', 'transparent'] as const).map((list) => new ForwardPass({ name: list, list, loop, reads }));
}
