import { type LabCase, type LabPlan, type LabSeries, plainCase } from '../plan/LabPlan';
import { lightKindNames, shadingNames } from '../plan/lightKinds';
import {
  type Check,
  fields,
  listOf,
  number,
  oneOf,
  orMissing,
  orNull,
  record,
  text,
  textLike,
  whole,
  yesOrNo,
} from './checks';

/** Version of the JSON format. */
export const LAB_RUN_VERSION = 1;

/** Limits of the lists of a run. */
const MOST = { rows: 20_000, cases: 200, series: 50, competitors: 50, passes: 100 };

const key = textLike(/^[a-z0-9][\w.@/:-]*$/i, 100, 'a key of letters, digits and hyphens');
const sentence = text(2000);
const sentences = listOf(sentence, 100);
const time = number(0, 1e9, 'ms');
const count = number(0, 1e12);
const pixels = whole(1, 16_384);

const parameter: Check<number | string | boolean> = (value, path) => {
  if (typeof value === 'boolean') return value;
  return typeof value === 'number' ? number(-1e12, 1e12)(value, path) : text(200)(value, path);
};

const labCase = fields<LabCase>({
  scene: fields({ name: key, parameters: record(parameter, 50) }),
  lights: orNull(whole(0, 1e7)),
  shadows: whole(0, 1e6),
  // this field and the next two are absent in older runs
  lightKind: orMissing(oneOf(...lightKindNames), plainCase.lightKind),
  lightRange: orMissing(orNull(number(0.1, 100, 'm')), plainCase.lightRange),
  shading: orMissing(oneOf(...shadingNames), plainCase.shading),
  overdraw: whole(0, 1e4),
  width: pixels,
  height: pixels,
});

const series = fields<LabSeries>({
  name: key,
  label: text(200),
  axis: oneOf('lights', 'objects', 'pixels', 'overdraw', 'shadows', 'kind', 'shading'),
  cases: listOf(labCase, MOST.cases),
  values: listOf(number(0, 1e12), MOST.cases),
});

const plan = fields<LabPlan>({
  preset: key,
  label: text(200),
  series: listOf(series, MOST.series),
  competitors: listOf(key, MOST.competitors, 1),
  effort: fields({
    rounds: whole(1, 1000),
    turn: time,
    changes: yesOrNo,
    longestFrame: time,
    limit: orNull(time),
  }),
});

const spread = fields({
  /** Median of the turns' medians. */
  median: time,
  /** 10th percentile of all samples; `high` is the 90th. */
  low: time,
  high: time,
  samples: whole(0, 1e9),
});
/** Median and spread of a time (ms) over all turns of a case. */
export type Spread = ReturnType<typeof spread>;

const counts = fields({
  draws: orNull(count),
  triangles: orNull(count),
  /** Programs linked since the competitor was opened for the case. */
  programs: orNull(count),
  /** Size of render targets and light data (bytes); null for competitors that do not report it. */
  targetBytes: orNull(count),
  /** Size of textures and buffers uploaded in a frame with moving lights, without uniforms (bytes). */
  uploadBytes: orNull(count),
});
/** Counts of one frame; null for WebGPU, where they are not measured. */
export type Counts = ReturnType<typeof counts>;

const passes = fields({
  kind: oneOf('gpu', 'cpu'),
  passes: listOf(fields({ name: text(200), ms: time }), MOST.passes),
});
/** Time of each pass (ms), measured on the GPU, or on the CPU without timer queries. */
export type PassTimes = ReturnType<typeof passes>;

const change = fields({
  ms: time,
  /** Programs linked in the frame; null for WebGPU. */
  programs: orNull(count),
});
/** Duration (ms) of the frame after a change, including the wait for the device to draw it. */
export type Change = ReturnType<typeof change>;

const likeness = fields({
  /** Key of the competitor that drew the reference. */
  reference: key,
  /** Peak signal-to-noise ratio of the 8-bit pictures (dB); null for equal pictures. */
  psnr: orNull(number(-1000, 1000, 'dB')),
  /**
   * The picture as a data URL, 160 pixels wide; empty in runs kept in the repository. No address of a host is allowed:
   * fetching it would reveal to the host who opens the file.
   */
  thumbnail: textLike(
    /^(data:image\/(webp|png|jpeg);base64,[A-Za-z0-9+/]*={0,2})?$/,
    400_000,
    'a WebP, PNG or JPEG picture as a data URL, or nothing',
  ),
});
/** Comparison of a competitor's picture with the reference of the case. */
export type Likeness = ReturnType<typeof likeness>;

const row = fields({
  /** Key of the competitor. */
  competitor: key,
  /** Name of the series, and index of the case within it. */
  series: key,
  index: whole(0, MOST.cases),
  frame: orNull(spread),
  cpu: orNull(spread),
  gpu: orNull(spread),
  firstMs: orNull(time),
  /** Frame after ten lights were added. */
  added: orNull(change),
  /** Frame after a change to another technique and back (only Farol). */
  changed: orNull(change),
  counts: orNull(counts),
  passes: orNull(passes),
  likeness: orNull(likeness),
  /** Number of lights that the competitor leaves out. */
  dropped: whole(0, 1e7),
  /** Technique that the competitor chose, and its reason; null if it does not choose. */
  technique: orNull(text(200)),
  reason: orNull(sentence),
  /** Reason, a sentence, why the competitor was not measured in the case; null if it was. */
  problem: orNull(sentence),
  /** Reasons to doubt the times, each a sentence: a drift between turns, a hidden tab, a wait for the display. */
  warnings: sentences,
});
/** Results of a competitor in a case. */
export type LabRow = ReturnType<typeof row>;

const surroundings = fields({
  /** Date and time, ISO 8601. */
  date: textLike(
    /^\d{4}-\d\d-\d\dT\d\d:\d\d(:\d\d(\.\d+)?)?(Z|[+-]\d\d:\d\d)$/,
    40,
    'a date as in 2026-11-22T18:00:00Z',
  ),
  /** Name of the graphics device, as reported by WebGL. */
  device: text(500),
  /** Name and version of the browser, and the operating system. */
  browser: text(500),
  system: text(500),
  /** Number of cores reported by the browser. */
  cores: orNull(whole(1, 1e5)),
  /** Version and commit of Farol. */
  build: text(200),
  /** Versions of the competitors' packages: three, playcanvas, @babylonjs/core. */
  versions: record(text(100), 50),
  /** Command that made the run; null for runs of the page. */
  command: orNull(sentence),
  /** Sentences on circumstances that make the whole run doubtful, such as a software rasteriser. */
  warnings: sentences,
});
/** Device, browser, versions and date of a run. */
export type LabSurroundings = ReturnType<typeof surroundings>;

/** Checks a run's fields. References between them are checked by `readRun`. */
export const checkRun = fields({
  format: oneOf('farol-lab-run'),
  version: oneOf(LAB_RUN_VERSION),
  /** Unique id: date and a random part. */
  id: key,
  /** Name given by the user; empty for none. */
  name: orMissing(text(200), ''),
  surroundings,
  plan,
  rows: listOf(row, MOST.rows),
  /** Whether every case was measured. */
  complete: yesOrNo,
  /** Wall time of the run (ms). */
  duration: time,
});
/** A finished or cancelled run: the JSON format of kept, exported and imported runs. */
export type LabRun = ReturnType<typeof checkRun>;

/** Kind of time that charts and tables compare. */
export type Metric = 'frame' | 'gpu' | 'cpu';
