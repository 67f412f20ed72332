import { LessEqualDepth } from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';

/** Writes the colour that three would have cleared to, where depth is still 1: behind all drawn surfaces. */
export class BackgroundDraw extends FullscreenPass {
  constructor() {
    super({
      program: 'background',
      vertex: 'farthest',
      fragment: 'background',
      shared: 'all',
      depthTest: true,
      // writes depth 1 where depth is 1, so that three's depth state need not change
      depthWrite: true,
      depthFunc: LessEqualDepth,
    });
  }
}
