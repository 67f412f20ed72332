import type { LabPlan } from '../plan/LabPlan';

/** Version of the JSON format. */
export const LAB_RUN_VERSION = 1;

/** Median and spread of a time (ms) over a case's turns. */
export interface Spread {
  /** Median of the turns' medians. */
  median: number;
  /** 10th and 90th percentile of all samples. */
  low: number;
  high: number;
  /** How many samples there are. */
  samples: number;
}

/** What one frame asks of WebGL. Null for WebGPU, which is not counted. */
export interface Counts {
  draws: number | null;
  triangles: number | null;
  /** Programs linked since the competitor was opened for the case. */
  programs: number | null;
  /** Bytes of render targets and light data, where the competitor tells them. */
  targetBytes: number | null;
  /** Bytes of textures and buffers sent to the device in a frame whose lights move; uniforms, as stock three's, do not count. */
  uploadBytes: number | null;
}

/** GPU or, without a timer, CPU time of each pass (ms). */
export interface PassTimes {
  kind: 'gpu' | 'cpu';
  passes: { name: string; ms: number }[];
}

/** A frame after something changed, waited for. */
export interface Change {
  ms: number;
  /** Programs linked in the frame; null for WebGPU. */
  programs: number | null;
}

/** How a competitor's picture compares with the reference of the case. */
export interface Likeness {
  /** Key of the competitor that drew the reference. */
  reference: string;
  /** Peak signal-to-noise ratio of the 8-bit pictures (dB); null for equal pictures. */
  psnr: number | null;
  /** The picture as a data URL (WebP or PNG, 160 pixels wide); empty in runs kept in the repository. */
  thumbnail: string;
}

/** What a competitor did in a case. */
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
  /** The frame after ten lights more. */
  added: Change | null;
  /** The frame after another technique was chosen and this one again (Farol alone). */
  changed: Change | null;
  counts: Counts | null;
  passes: PassTimes | null;
  likeness: Likeness | null;
  /** Lights that the competitor leaves out. */
  dropped: number;
  /** Technique that drew, where the competitor picks one, and why. */
  technique: string | null;
  reason: string | null;
  /** Why there is no figure, as a sentence; null when there is one. */
  problem: string | null;
  /** What spoils the figure, as sentences: throttling seen as drift, a hidden tab, a display-limited rate. */
  warnings: string[];
}

/** Where and when a run was made. */
export interface LabSurroundings {
  /** Date and time, ISO 8601. */
  date: string;
  /** Graphics device as WebGL names it. */
  device: string;
  /** Browser's name and version; operating system. */
  browser: string;
  system: string;
  /** Cores that the browser tells of. */
  cores: number | null;
  /** Version and commit of Farol. */
  build: string;
  /** Versions of the competitors' packages: three, playcanvas, @babylonjs/core. */
  versions: Record<string, string>;
  /** The command that made the run; null in the page. */
  command: string | null;
  /** What spoils the whole run, as sentences: a software rasteriser, a hidden tab. */
  warnings: string[];
}

/** A finished or cancelled run: the JSON that is kept, exported, imported and compared. */
export interface LabRun {
  format: 'farol-lab-run';
  version: typeof LAB_RUN_VERSION;
  /** Unique, made of date and a random part. */
  id: string;
  /** A name given by the user; empty for none. */
  name: string;
  surroundings: LabSurroundings;
  plan: LabPlan;
  rows: LabRow[];
  /** Whether every case was measured. */
  complete: boolean;
  /** Wall time of the run (ms). */
  duration: number;
}

/** The number that charts and sentences compare: GPU time where both have it, else throughput. */
export type Metric = 'frame' | 'gpu' | 'cpu';
