import type { LabPlan } from '../plan/LabPlan';

/** Version of the JSON format. */
export const LAB_RUN_VERSION = 1;

/** Median and spread of a time (ms) over all turns of a case. */
export interface Spread {
  /** Median of the turns' medians. */
  median: number;
  /** 10th percentile of all samples; `high` is the 90th. */
  low: number;
  high: number;
  samples: number;
}

/** Counts of one frame; null for WebGPU, where they are not measured. */
export interface Counts {
  draws: number | null;
  triangles: number | null;
  /** Programs linked since the competitor was opened for the case. */
  programs: number | null;
  /** Size of render targets and light data (bytes); null for competitors that do not report it. */
  targetBytes: number | null;
  /** Size of textures and buffers uploaded in a frame with moving lights, without uniforms (bytes). */
  uploadBytes: number | null;
}

/** Time of each pass (ms), measured on the GPU, or on the CPU without timer queries. */
export interface PassTimes {
  kind: 'gpu' | 'cpu';
  passes: { name: string; ms: number }[];
}

/** Duration (ms) of the frame after a change, including the wait for the device to draw it. */
export interface Change {
  ms: number;
  /** Programs linked in the frame; null for WebGPU. */
  programs: number | null;
}

/** Comparison of a competitor's picture with the reference of the case. */
export interface Likeness {
  /** Key of the competitor that drew the reference. */
  reference: string;
  /** Peak signal-to-noise ratio of the 8-bit pictures (dB); null for equal pictures. */
  psnr: number | null;
  /** The picture as a data URL (WebP or PNG, 160 pixels wide); empty in runs kept in the repository. */
  thumbnail: string;
}

/** Results of a competitor in a case. */
export interface LabRow {
  /** Key of the competitor. */
  competitor: string;
  /** Name of the series, and index of the case within it. */
  series: string;
  index: number;
  frame: Spread | null;
  cpu: Spread | null;
  gpu: Spread | null;
  firstMs: number | null;
  /** Frame after ten lights were added. */
  added: Change | null;
  /** Frame after a change to another technique and back (only Farol). */
  changed: Change | null;
  counts: Counts | null;
  passes: PassTimes | null;
  likeness: Likeness | null;
  /** Number of lights that the competitor leaves out. */
  dropped: number;
  /** Technique that the competitor chose, and its reason; null if it does not choose. */
  technique: string | null;
  reason: string | null;
  /** Reason, a sentence, why the competitor was not measured in the case; null if it was. */
  problem: string | null;
  /** Reasons to doubt the times, each a sentence: a drift between turns, a hidden tab, a wait for the display. */
  warnings: string[];
}

/** Device, browser, versions and date of a run. */
export interface LabSurroundings {
  /** Date and time, ISO 8601. */
  date: string;
  /** Name of the graphics device, as reported by WebGL. */
  device: string;
  /** Name and version of the browser, and the operating system. */
  browser: string;
  system: string;
  /** Number of cores reported by the browser. */
  cores: number | null;
  /** Version and commit of Farol. */
  build: string;
  /** Versions of the competitors' packages: three, playcanvas, @babylonjs/core. */
  versions: Record<string, string>;
  /** Command that made the run; null for runs of the page. */
  command: string | null;
  /** Sentences on circumstances that make the whole run doubtful, such as a software rasteriser. */
  warnings: string[];
}

/** A finished or cancelled run: the JSON format of kept, exported and imported runs. */
export interface LabRun {
  format: 'farol-lab-run';
  version: typeof LAB_RUN_VERSION;
  /** Unique id: date and a random part. */
  id: string;
  /** Name given by the user; empty for none. */
  name: string;
  surroundings: LabSurroundings;
  plan: LabPlan;
  rows: LabRow[];
  /** Whether every case was measured. */
  complete: boolean;
  /** Wall time of the run (ms). */
  duration: number;
}

/** Kind of time that charts and tables compare. */
export type Metric = 'frame' | 'gpu' | 'cpu';
