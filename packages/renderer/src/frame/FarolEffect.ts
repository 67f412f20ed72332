import type { WebGLRenderer } from 'three';
import type { Frame } from './Frame';
import type { GBufferAttachment } from '../gbuffer/gbufferLayout';
import type { Pass, Resource } from './Pass';
import type { RenderItem } from './RenderItem';
import type { Technique } from './Technique';
import type { TwinKind } from '../materials/TwinKind';

/**
 * An optional part of a frame, with any technique: `farol.effects = [new TAA()]`. The core has only this interface; effects have
 * their own package entries, such as `@farol/renderer/antialiasing`. Effects run in the order of the list, only in the view
 * 'final'. An effect object belongs to one FarolRenderer.
 */
export interface FarolEffect {
  /** Name of the effect in `FarolInfo.passes`. */
  readonly name: string;
  /** Resources; `render` is called after each pass of the frame that writes one of them. */
  readonly after?: readonly Resource[];
  /** Resource; `render` is called in place of each pass that writes it. At most one effect may replace a resource. */
  readonly replaces?: Resource;
  /**
   * Additional attachments of the G-buffer, if the device has room; `Frame.locationOf` gives their locations. Names must be
   * unique among effects. Keep the objects: new ones cause new G-buffers. Default none.
   */
  readonly attachments?: readonly GBufferAttachment[];
  /** True if `begin` sets `frame.camera`; at most one effect may, and no effect in XR sessions. Default false. */
  readonly movesCamera?: boolean;
  /** True if the effect works on a G-buffer: 'auto' then picks a technique that has a G-buffer. Default false. */
  readonly needsSurfaces?: boolean;
  /**
   * The end of the sentence "this device …" for a device that the effect cannot draw on, such as 'draws to no float colour
   * buffers'; null for others. The effect is left out there, with one warning. Default null.
   */
  lacks?(webgl: WebGLRenderer): string | null;
  /**
   * True if `begin` redirects the frame to a target of the effect: the effect is then left out for targets with several
   * textures. Default false.
   */
  readonly takesPicture?: boolean;
  /** True if the effect smooths edges: `FarolOptions.antialias` adds nothing then. Default false. */
  readonly smoothsEdges?: boolean;
  /**
   * Number of frames after which a still scene's picture no longer changes, if it depends on the device. Default: the effect
   * entry's.
   */
  readonly stillFrames?: number;
  /** Bytes of the effect's targets. */
  readonly bytes: number;
  /**
   * Called before anything is drawn and before three's traversal; may set `frame.camera` (a stand-in for the host's, such as a
   * jittered one) and `frame.target` with its viewport.
   */
  begin?(frame: Frame): void;
  /**
   * Called once the frame's technique is picked, before anything is drawn; may set `frame.target` with its
   * viewport of the same size.
   */
  picked?(frame: Frame, technique: Technique): void;
  /**
   * Called inside three's `render`, where `frame` can draw, before the frame's draws: computes data that lights and
   * passes read. Called again before objects are drawn for transmission. Must leave the bound target as it was.
   */
  compute?(frame: Frame): void;
  /**
   * Returns the kind of twin to draw an item with: `kind`, or another one, by `kind.role`. Called for each draw; each effect
   * receives the result of the previous effect. Must not allocate in steady state.
   */
  adapt?(kind: TwinKind, item: RenderItem): TwinKind;
  /**
   * Draws, inside three's `render`, with the resources in `frame.resources`.
   * @param pass - the pass that was drawn, or that is to be replaced
   */
  render?(frame: Frame, pass: Pass): void;
  /** Called inside three's `render` after all passes; measured for `FarolInfo.passes` unless there is `after`. */
  end?(frame: Frame): void;
  /**
   * Compiles the programs for a technique that 'auto' is about to change to, one in each call, with a frame whose draws draw
   * nothing.
   */
  warmUp?(frame: Frame): void;
  /** Forgets data of earlier frames. */
  reset?(): void;
  /** Frees the GPU resources; a later frame creates them again. */
  dispose(): void;
}
