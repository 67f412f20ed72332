import type { LearntChoice } from '@farol/renderer';
import type { LabCase } from '../plan/LabPlan';
import type { Change, Counts, PassTimes } from '../results/LabRun';

/** First frame of a competitor in a case. */
export interface Opened {
  /** Time of the first frame, including compiling, uploads and the wait for the device (ms). */
  firstMs: number;
  /** Number of lights that the competitor leaves out, by its own count. */
  dropped: number;
  /** Technique that the competitor chose, and its reason; null if it does not choose. */
  technique: string | null;
  reason: string | null;
  /** The picture at t = 1 s: 8-bit sRGB, RGBA, top row first, at most 320 pixels wide. */
  picture: ImageData;
}

/** Frame times (ms) of one turn, in which only one competitor is measured. */
export interface Turn {
  /** Wall times per frame, from batches of frames with one wait each; the cost of the wait is subtracted. */
  frame: number[];
  /** Durations of the competitor's drawing call. */
  cpu: number[];
  /** GPU times per frame by timer query; null without timer queries and on a software rasteriser. */
  gpu: number[] | null;
}

/**
 * Interface of the page `stage.html`, its `window.stage`: competitors that draw in one iframe, each with a context on a
 * canvas outside of the document, so that nothing is presented and no drawn frame waits for the display.
 */
export interface Stage {
  /**
   * Opens a competitor for a case and draws its first frame. Several competitors may be open at once.
   *
   * @param competitor - key in `competitors`
   * @throws Error (as a rejection) naming what the device, the browser or the competitor does not support
   */
  open(competitor: string, labCase: LabCase, options: { signal: AbortSignal; longestFrame: number }): Promise<Opened>;
  /** Draws frames with moving lights for about `ms` milliseconds; returns at least 3 samples of each kind of time. */
  turn(competitor: string, ms: number): Promise<Turn>;
  /** Counts draws, programs and bytes of one frame; called after the turns. */
  count(competitor: string): Promise<Counts>;
  /** Times of the passes; null for competitors other than Farol's. */
  passes(competitor: string): Promise<PassTimes | null>;
  /** Measures the frame after ten lights were added, and removes them again. */
  addLights(competitor: string): Promise<Change>;
  /** Measures the frame after a change to another technique and back; null for competitors with one technique. */
  changeTechnique(competitor: string): Promise<Change | null>;
  /** Frees the competitor's context and memory. */
  close(competitor: string): void;
  /** Reason, a sentence, why the competitor cannot draw on this browser or device; null if it can. */
  unavailable(competitor: string): Promise<string | null>;
  /** Sets the scene `own`: bytes of a scene file of the engine with its assets. */
  setOwnScene(file: Uint8Array): Promise<void>;
  /** Graphics device by WEBGL_debug_renderer_info, its features, and the name of the WebGPU adapter. */
  device(): Promise<{ renderer: string; timer: boolean; software: boolean; webgpu: string | null }>;
  /** Lets `auto` learn in a case, see `learnCase`. Absent in older builds, as are the next two members. */
  learn?(labCase: LabCase, signal: AbortSignal, onShare: (share: number) => void): Promise<void>;
  /** Techniques that `auto` has learnt in this browser. */
  learnt?(): Promise<LearntChoice[]>;
  clearLearnt?(): Promise<void>;
}

declare global {
  interface Window {
    stage?: Stage;
  }
}
