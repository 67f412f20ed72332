import type { Fills } from './Fills';
import type { Lazy } from './Lazy';
import type { Pass, Resource } from './Pass';
import type { LightOrder } from '../lighting/LightTable';

/** A way of drawing: an array of passes, which share `frame.resources`. */
export interface Technique {
  /** Name of the technique in menus. */
  readonly label: string;
  /** One line of help on the technique. */
  readonly help: string;
  /** Order of lights in the table that the passes need. */
  readonly lightOrder: LightOrder;
  /** Whether the technique draws to float colour targets. */
  readonly needsFloatTargets: boolean;
  /** Pixels that the technique writes, so that three need not clear them; null for none. Default 'behind'. */
  readonly fills?: Fills | null;
  /** Whether all shaders of the technique can read lights from uniforms, if few (fewLights.glsl). Default false. */
  readonly readsFew?: boolean;
  /**
   * Late code of the technique, fetched at its first use; until it is loaded the technique that drew the scene last draws, or
   * else 'deferred', or 'forward-single-pass' where lights are few or the device has no float targets. Default: the code that
   * `lightOrder` needs.
   */
  readonly lazy?: Lazy<object>;
  /**
   * Which of `gbuffer` and `scene-depth` (at full size) the passes write, known before `lazy` is loaded. Default: read from the
   * passes of a technique without late code.
   */
  readonly writes?: readonly Resource[];
  /** Makes a renderer's passes, in drawing order. @throws Error while `lazy` is not loaded */
  passes(): Pass[];
}
