import { LessEqualDepth } from 'three';
import { FullscreenPass } from '../gpu/FullscreenPass';

/** Writes the colour that three would have cleared the target to behind all that is drawn: only where depth is still 1. */
export class BackgroundDraw extends FullscreenPass {
  constructor() {
    super({
      program: 'background',
      vertex: 'farthest',
      fragment: 'background',
      shared: 'all',
      depthTest: true,
      // of 1 where it is 1: three's usual state stays as it is
      depthWrite: true,
      depthFunc: LessEqualDepth,
    });
  }
}
