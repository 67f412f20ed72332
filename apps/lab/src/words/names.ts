import { t } from '@farol/editing';
import { competitorNames, type CompetitorWords } from '../competitors/competitorNames';
import { type Axis, isNamed, type LabCase, type LabSeries } from '../plan/LabPlan';
import { lightKindNames, lightKinds, shadingNames, shadings } from '../plan/lightKinds';
import type { Metric } from '../results/LabRun';
import { formatNumber } from './format';

const known: ReadonlyMap<string, CompetitorWords> = new Map(Object.entries(competitorNames));

/** Name of a competitor in menus and tables; its key if this version does not know it. */
export function competitorLabel(name: string): string {
  const words = known.get(name);
  return words ? t(words.label) : name;
}

/** Explanation of a competitor, one sentence; its key if this version does not know it. */
export function competitorHelp(name: string): string {
  const words = known.get(name);
  return words ? t(words.help) : name;
}

const inSentences: Readonly<Record<string, string>> = {
  // this name is without the label's comma, which would separate items in a list
  'forward-single-pass': 'single-pass forward',
  stock: 'three’s WebGLRenderer',
  multipass: 'naive multipass',
  'three-webgpu': 'three’s WebGPU',
  playcanvas: 'PlayCanvas',
  babylon: 'Babylon.js',
};

/** Short name of a competitor within a text or beside a line. */
export function competitorWord(name: string): string {
  return Object.hasOwn(inSentences, name) ? t(inSentences[name]) : competitorLabel(name).replace(/^Farol: /, '');
}

/** Whether a competitor is a technique of Farol's other than `auto`. */
export function isTechnique(name: string): boolean {
  return name !== 'auto' && competitorKind(name) === 'farol';
}

/** Kind of a competitor; null if this version does not know it. */
export function competitorKind(name: string): 'farol' | 'three' | 'rival' | null {
  return known.get(name)?.kind ?? null;
}

const units: Readonly<Record<Axis, readonly [one: string, many: string]>> = {
  lights: ['light', 'lights'],
  objects: ['object', 'objects'],
  pixels: ['pixel', 'pixels'],
  overdraw: ['layer', 'layers'],
  shadows: ['shadowed light', 'shadowed lights'],
  kind: ['kind of lights', 'kinds of lights'],
  shading: ['shading', 'shadings'],
};

/** Name of a value along an axis of names: `rectangles`, `flat shading`; its index if this version does not know it. */
export function namedValue(axis: 'kind' | 'shading', value: number): string {
  const words = axis === 'kind' ? lightKinds[lightKindNames[value]] : shadings[shadingNames[value]];
  return words ? t(words.word) : String(value);
}

/**
 * A value with its unit: `1 light`, `2,500 objects`; pixels of a known case as `1280 × 720`; the name of the value
 * along an axis of names.
 */
export function valueText(axis: Axis, value: number, labCase?: LabCase): string {
  if (axis === 'pixels' && labCase) return `${labCase.width} × ${labCase.height}`;
  if (isNamed(axis)) return namedValue(axis, value);
  return `${formatNumber(value, 6)} ${t(units[axis][value === 1 ? 0 : 1])}`;
}

/** Value of a case along its axis, without unit: `100`, `1280 × 720`, `rectangles`. */
export function caseText({ axis, cases, values }: LabSeries, index: number): string {
  if (isNamed(axis)) return namedValue(axis, values[index]);
  const { width, height } = cases[index];
  return axis === 'pixels' ? `${width} × ${height}` : formatNumber(values[index]);
}

/** Ending of a title that names the metric, empty for frame times: `, by GPU time`. */
export const byMetric = (metric: Metric): string =>
  metric === 'frame' ? '' : `, ${t('by {time}', { time: t(metricWords[metric].noun) })}`;

/** Texts of the metrics: label for buttons, noun within texts, and explanation. */
export const metricWords: Readonly<Record<Metric, { label: string; noun: string; help: string }>> = {
  frame: {
    label: 'Frame',
    noun: 'frame time',
    help: 'Frames in batches, each batch waited for: CPU and GPU together.',
  },
  gpu: { label: 'GPU', noun: 'GPU time', help: 'GPU time of a frame, by timer query.' },
  cpu: { label: 'CPU', noun: 'CPU time', help: 'Time inside the call that draws.' },
};
