import type { ViewInfo } from '../frame/ViewInfo';
import type { BudgetInfo } from './FrameBudget';

/** Counts of draws and times of one pass in the last frame. */
export interface PassInfo {
  /** Name of the pass; those of an XR session's second eye end in ", eye 2". */
  readonly name: string;
  drawCalls: number;
  triangles: number;
  /** CPU time of the pass's JavaScript (ms). */
  cpuMs: number;
  /** GPU time (ms), some frames old; null in the first frames, without EXT_disjoint_timer_query_webgl2 or with `timing` off. */
  gpuMs: number | null;
}

/** Bytes that Farol holds on the GPU, by their use; three's own and the host's textures are not counted. */
export interface MemoryInfo {
  /** Bytes of G-buffers, depth included. */
  gbuffer: number;
  /** Bytes of a pixel of the frame's G-buffer, depth (4 bytes) left out; 0 without a G-buffer. */
  gbufferPixel: number;
  /** Bytes of other targets of techniques and views. */
  targets: number;
  /** Bytes of the lists of lights by tile or cluster. */
  lists: number;
  /** Bytes of the atlases of shadow maps, cookies and profiles, and of the depth bounds of shadow maps. */
  shadows: number;
  /** Bytes of light tables, and of the tables of area lights and light fields. */
  lights: number;
  /** Bytes of effects' buffers, those of the option `antialias` included. */
  effects: number;
}

/** Figures of the last frame. The same object and the same pass objects every frame: read, do not keep. */
export interface FarolInfo {
  /** Key of the technique that drew. */
  technique: string;
  /** Sentence on why the technique was chosen. */
  reason: string;
  /** Advice for faster frames, one sentence; null for none. From 2,000 light objects on it recommends LightField. */
  hint: string | null;
  /**
   * Names of the parts of Farol's code that the frame needs and that are not loaded yet: being fetched, or to be fetched again
   * after a failure. A new array at each read.
   */
  readonly pending: readonly string[];
  readonly passes: PassInfo[];
  drawCalls: number;
  triangles: number;
  /** CPU time of the whole `render` call (ms). */
  cpuMs: number;
  /** Sum of the passes' GPU times (ms); null where they are not known. */
  gpuMs: number | null;
  /** Scale that `FarolOptions.budget` chose for the picture, and why; null without a budget. */
  budget: Readonly<BudgetInfo> | null;
  /** Parts of the shown view of a buffer, or why it cannot be shown; null for other views, and while code is fetched. */
  view: ViewInfo | null;
  /**
   * Number of lights in the scene, and of those that may light what the camera sees; each counts all lights of LightFields.
   * `visible` is an estimate where the GPU sorts thousands of point lights.
   */
  lights: { total: number; visible: number };
  /**
   * Numbers of shadow maps drawn in this frame, of their texels, of maps kept from earlier frames, and of kept maps whose depth
   * bounds spare look-ups; bytes of the atlases.
   */
  shadows: { drawn: number; texels: number; kept: number; bounded: number; bytes: number };
  /** Number of programs alive in the WebGLRenderer. */
  programs: number;
  /** Quality of the frame: 'lite' or 'full'. */
  quality: 'full' | 'lite';
  /** Bytes that Farol holds on the GPU, by use, counted on each read. */
  readonly memory: MemoryInfo;
  /** Sum of all kinds of `memory`. */
  readonly targetBytes: number;
  /** Bytes of light data uploaded in this frame. */
  uploadBytes: number;
}
