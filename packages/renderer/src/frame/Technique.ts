import type { Fills } from './Fills';
import type { Lazy } from './Lazy';
import type { Pass, Resource } from './Pass';
import type { LightOrder } from '../lighting/LightTable';

/** A way of drawing: an array of passes, which hand one another `frame.resources`. */
export interface Technique {
  /** Name in menus. */
  readonly label: string;
  /** One line of help. */
  readonly help: string;
  /** How its passes want the lights in the table. */
  readonly lightOrder: LightOrder;
  /** True if it draws to float colour targets. */
  readonly needsFloatTargets: boolean;
  /** Its part in clearing the target: what it writes where nothing is. Default 'behind'. */
  readonly fills?: Fills;
  /**
   * Code that is fetched when the technique is asked for; until it is there 'deferred' draws, or 'forward-single-pass' where
   * lights are few or the device has no float targets. Default: that of `lightOrder`.
   */
  readonly lazy?: Lazy<object>;
  /**
   * `gbuffer`, or else `scene-depth` of the picture's size, where its passes write it: for whoever asks before `lazy` is there.
   * Default none; where no code is fetched the passes say it.
   */
  readonly writes?: readonly Resource[];
  /** The passes, in the order in which they draw; each renderer has its own. @throws Error while `lazy` is not there */
  passes(): Pass[];
}
