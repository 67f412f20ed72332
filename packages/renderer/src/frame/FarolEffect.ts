import type { WebGLRenderer } from 'three';
import type { Frame } from './Frame';
import type { GBufferAttachment } from '../gbuffer/gbufferLayout';
import type { Pass, Resource } from './Pass';
import type { RenderItem } from './RenderItem';
import type { Technique } from './Technique';
import type { TwinKind } from '../materials/TwinKind';

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
  /** `render` is called in the place of each pass that writes this. Of one resource at most one effect may. */
  readonly replaces?: Resource;
  /**
   * Attachments that a G-buffer is to have besides, while the device has room for them: `Frame.locationOf` tells where.
   * Of one name at most one effect may ask. Keep the objects: new ones make G-buffers anew. Default none.
   */
  readonly attachments?: readonly GBufferAttachment[];
  /** True if `begin` sets `frame.camera`; at most one effect may. Default false. */
  readonly movesCamera?: boolean;
  /** True if it works on a G-buffer: the technique 'auto' then picks one that has it. Default false. */
  readonly needsSurfaces?: boolean;
  /**
   * The end of the sentence "this device …" for a device that the effect cannot draw on, such as 'draws to no float colour
   * buffers'; null for others. The effect is left out there, with one warning. Default null.
   */
  lacks?(webgl: WebGLRenderer): string | null;
  /** True if `begin` has the frame drawn to a target of the effect: targets with several textures then go without. Default false. */
  readonly takesPicture?: boolean;
  /** True if it smooths edges: `FarolOptions.antialias` adds nothing then. Default false. */
  readonly smoothsEdges?: boolean;
  /** Bytes of the effect's targets. */
  readonly bytes: number;
  /**
   * Called before anything is drawn and before three's traversal; may set `frame.camera` (a view of the host's, such as a
   * jittered one) and `frame.target` with its viewport.
   */
  begin?(frame: Frame): void;
  /**
   * Called when it is known which technique draws the frame, still before anything is drawn; may set `frame.target` with its
   * viewport of the same size.
   */
  picked?(frame: Frame, technique: Technique): void;
  /**
   * Called inside three's `render`, where `frame` draws, before anything of the frame is drawn: for what lights and passes then
   * read. What is seen through transmissive things is a drawing of its own, before which it is called too. It leaves the
   * target bound that it finds bound.
   */
  compute?(frame: Frame): void;
  /**
   * Gives the kind of twin that an item is drawn with in place of another, or that one: by `kind.role`. Called for each draw,
   * in the order of the effects, each with what the one before gave; must not allocate in steady state.
   */
  adapt?(kind: TwinKind, item: RenderItem): TwinKind;
  /** Draws, inside three's `render`, by what is in `frame.resources`. @param pass - the pass that was drawn, or that is to be replaced */
  render?(frame: Frame, pass: Pass): void;
  /** Called inside three's `render` after all passes; has figures in `FarolInfo.passes` unless there is `after`. */
  end?(frame: Frame): void;
  /**
   * Draws as in a frame, where 'auto' is about to change to a technique that the effect is for: nothing is drawn, programs are
   * compiled, one a call.
   */
  warmUp?(frame: Frame): void;
  /** Forgets what it has gathered over earlier frames. */
  reset?(): void;
  /** Frees the GPU resources; a later frame makes them anew. */
  dispose(): void;
}
