import type { WebGLRenderer } from 'three';
import type { Frame } from './Frame';
import type { Pass, Resource } from './Pass';
import type { Technique } from '../techniques/Technique';

/**
 * Something optional that takes part in a frame of any technique: `farol.effects = [new TAA()]`. The core knows only this;
 * the effects themselves are entries of their own, such as `@farol/renderer/antialiasing`. Effects run in their order,
 * in the view 'final' only. One object serves one FarolRenderer.
 */
export interface FarolEffect {
  /** Name in `FarolInfo.passes`. */
  readonly name: string;
  /** `render` is called after each pass of the frame that writes one of these. */
  readonly after?: readonly Resource[];
  /** `render` is called in the place of the pass of this name. */
  readonly replaces?: string;
  /** True if it works on a G-buffer: the technique 'auto' then picks one that has it. Default false. */
  readonly needsSurfaces?: boolean;
  /**
   * What "this device" does not do or have that the effect needs, such as 'draws to no float colour buffers'; null if nothing.
   * An effect that lacks something is left out, with one warning. Default null.
   */
  lacks?(webgl: WebGLRenderer): string | null;
  /** True if the frame is drawn to a picture of the effect's: it is left out in targets with several textures. Default false. */
  readonly takesPicture?: boolean;
  /** Bytes of the targets that it holds. */
  readonly bytes: number;
  /**
   * Called before anything is drawn and before three's traversal; may set `frame.camera` (a view of the host's, such as a
   * jittered one), `frame.target` with its viewport, `frame.adapt` and `frame.gbufferLayout`.
   */
  begin?(frame: Frame): void;
  /**
   * Called when it is known which technique draws the frame, still before anything is drawn; may set `frame.target` with its
   * viewport of the same size.
   */
  picked?(frame: Frame, technique: Technique): void;
  /** Draws, inside three's `render`. @param pass the pass that was drawn, or that is to be replaced */
  render?(frame: Frame, pass: Pass): void;
  /** Called inside three's `render` after all passes; has figures in `FarolInfo.passes` unless there is `after`. */
  end?(frame: Frame): void;
  /** Frees its GPU resources; it makes them anew when it is used again. */
  dispose(): void;
}
