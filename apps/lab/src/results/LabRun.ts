import type { LabPlan } from '../plan/LabPlan';

/** Version of the JSON format. */
export const LAB_RUN_VERSION = 1;

/** Median and spread of a time (ms) over all turns of a case. */
export interface Spread {
  /** Median of the turns' medians. */
  median: number;
  /** 10th and 90th percentile of all samples. */
  low: number;
  high: number;
  samples: number;
}

/** Counts of one frame; null for WebGPU, which is not counted. */
export interface Counts {
  draws: number | null;
  triangles: number | null;
  /** Programs linked since the competitor was opened for the case. */
  programs: number | null;
  /** Bytes of render targets and light data; null for competitors that do not report them. */
  targetBytes: number | null;
  /** Bytes of textures and buffers uploaded in a frame with moving lights, without uniforms. */
  uploadBytes: number | null;
}

/** Time of each pass (ms): of the GPU, or of the CPU without timer queries. */
export interface PassTimes {
  kind: 'gpu' | 'cpu';
  passes: { name: string; ms: number }[];
}

/** Frame after a change, with the wait for the device. */
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
  /** Name of the series and index of the case in it. */
  series: string;
  index: number;
  frame: Spread | null;
  cpu: Spread | null;
  gpu: Spread | null;
  firstMs: number | null;
  /** Frame after ten lights more. */
  added: Change | null;
  /** Frame after a change to another technique and back (Farol alone). */
  changed: Change | null;
  counts: Counts | null;
  passes: PassTimes | null;
  likeness: Likeness | null;
  /** Number of lights that the competitor leaves out. */
  dropped: number;
  /** Technique chosen by the competitor, and its reason; null if it has none to choose. */
  technique: string | null;
  reason: string | null;
  /** Reason, a sentence, why there are no figures; null if there are. */
  problem: string | null;
  /** Sentences on doubtful figures: a drift between turns, a hidden tab, a wait for the display. */
  warnings: string[];
}

/** Place and time of a run. */
export interface LabSurroundings {
  /** Date and time, ISO 8601. */
  date: string;
  /** Graphics device as WebGL names it. */
  device: string;
  /** Browser's name and version; operating system. */
  browser: string;
  system: string;
  /** Cores reported by the browser. */
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
  /** Unique: date and a random part. */
  id: string;
  /** Name by the user; empty for none. */
  name: string;
  surroundings: LabSurroundings;
  plan: LabPlan;
  rows: LabRow[];
  /** Whether every case was measured. */
  complete: boolean;
  /** Wall time of the run (ms). */
  duration: number;
}

/** Time by which charts and tables compare. */
export type Metric = 'frame' | 'gpu' | 'cpu';
