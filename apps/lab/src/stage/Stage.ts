import type { NormalsPicture, NormalsWay } from '../normals/NormalsPicture';
import type { LabCase } from '../plan/LabPlan';
import type { Change, Counts, PassTimes } from '../results/LabRun';

/** What a competitor's first frame of a case was. */
export interface Opened {
  /** Time of the first frame, programs and uploads included, waited for (ms). */
  firstMs: number;
  /** Lights that the competitor says it leaves out. */
  dropped: number;
  /** Technique that drew, where the competitor picks one, and why. */
  technique: string | null;
  reason: string | null;
  /** The picture at t = 1 s: 8-bit sRGB, RGBA, top row first, 320 pixels wide at most. */
  picture: ImageData;
}

/** Samples of one turn, in ms; null where the device or the competitor cannot tell. */
export interface Turn {
  /** Wall time of a frame: batches of frames with one wait each, the wait's own cost taken off. */
  frame: number[];
  /** Time inside the competitor's call that draws. */
  cpu: number[];
  /** GPU time of a frame by timer query; null where there is no GPU, but a software rasteriser. */
  gpu: number[] | null;
}

/**
 * What the page `stage.html` offers as `window.stage`: competitors of one realm, each with a canvas and a context of its
 * own, outside of the document, so that nothing is presented and no display is waited for.
 */
export interface Stage {
  /**
   * Makes a competitor ready for a case and draws its first frame. Several competitors may be open at once.
   *
   * @param competitor - key in `competitors`
   * @throws Error (as a rejection) that names what the device, the browser or the competitor cannot do
   */
  open(competitor: string, labCase: LabCase, options: { signal: AbortSignal; longestFrame: number }): Promise<Opened>;
  /** Draws frames whose lights move, for about `ms` (ms), 3 of each kind at least. */
  turn(competitor: string, ms: number): Promise<Turn>;
  /** Draws, programs and bytes of one frame, once the turns are over. */
  count(competitor: string): Promise<Counts>;
  /** Times of the passes, where the competitor tells them (Farol alone). */
  passes(competitor: string): Promise<PassTimes | null>;
  /** The frame after ten lights more, waited for; the lights go again. */
  addLights(competitor: string): Promise<Change>;
  /** The frame after another technique was chosen and the competitor's own again, waited for; null where it has none. */
  changeTechnique(competitor: string): Promise<Change | null>;
  /** Frees the competitor's context and memory. */
  close(competitor: string): void;
  /** Whether the browser and the device have what the competitor needs; a sentence when not. */
  unavailable(competitor: string): Promise<string | null>;
  /** Hands over the scene `own`: a scene file of the engine with its assets (`serializeScene`), as bytes. */
  setOwnScene(file: Uint8Array): Promise<void>;
  /** Name of the graphics device, by WEBGL_debug_renderer_info, and whether timer queries are there. */
  device(): Promise<{ renderer: string; timer: boolean; software: boolean; webgpu: string | null }>;
  /**
   * Draws one of the two pictures of figure 4.3 of the thesis, of this size (pixels). Only a page's own build has it.
   *
   * @throws Error (as a rejection) that names what the device or the browser cannot do
   */
  drawNormals?(way: NormalsWay, size: { readonly width: number; readonly height: number }): Promise<NormalsPicture>;
}

declare global {
  interface Window {
    stage?: Stage;
  }
}
