import { tCount } from '@farol/editing';
import type { LabCase } from '../plan/LabPlan';
import type { LabRun, Metric } from '../results/LabRun';
import { valueText } from '../words/names';
import { type Entry, entriesOf } from '../words/rowsOf';
import { casesOf, type SeriesCase } from '../words/seriesCases';
import { thesis2015, type ThesisRow } from './thesis2015';

/** A measurement published in the thesis, beside the corresponding case of a run. */
export interface ThesisPair {
  readonly thesis: ThesisRow;
  readonly label: string;
  /** Corresponding case of the run; null if the run has none. */
  readonly of: SeriesCase | null;
  /** Times of all competitors in the case, shortest first. */
  readonly entries: readonly Entry[];
}

const scenes: Readonly<Record<ThesisRow['table'], string>> = {
  planes: 'benchmarkLights',
  sponza: 'sponza',
  temple: 'temple',
};

/** All rows of the thesis in order, each with the first case of the run with the same scene, planes and lights. */
export function compareThesis(run: LabRun, metric: Metric): ThesisPair[] {
  const cases = casesOf(run);
  return thesis2015.map((thesis) => {
    const of = cases.find(({ labCase }) => isCaseOf(labCase, thesis)) ?? null;
    const entries = of === null ? [] : entriesOf(run, of.series, of.index, metric);
    return { thesis, label: labelOf(thesis), of, entries };
  });
}

function isCaseOf({ scene, lights, shadows, overdraw, ...matter }: LabCase, row: ThesisRow): boolean {
  const isPlain = matter.lightKind === 'points' && matter.lightRange === null && matter.shading === 'own';
  const hasPlanes = row.planes === 0 || Number(scene.parameters.n) ** 2 === row.planes;
  const plain = isPlain && shadows === 0 && overdraw === 0;
  return scene.name === scenes[row.table] && hasPlanes && lights === row.lights && plain;
}

function labelOf({ planes, lights }: ThesisRow): string {
  const light = valueText('lights', lights);
  return planes === 0 ? light : `${tCount(planes, '{count} plane', '{count} planes')}, ${light}`;
}

/** A competitor's time in a row; undefined without one. */
export function timeIn({ entries }: ThesisPair, competitor: string): Entry['time'] | undefined {
  return entries.find((entry) => entry.competitor === competitor)?.time;
}
