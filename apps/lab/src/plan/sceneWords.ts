import { t } from '@farol/editing';
import type { Axis, LabSeries } from './LabPlan';

export interface SceneWords {
  readonly label: string;
  readonly help: string;
  readonly axes: readonly Axis[];
}

const lit = ['lights', 'pixels', 'overdraw', 'shadows', 'kind', 'shading'] as const;

/** Scenes by key in `@farol/scenes`; `own` is the scene handed over by the editor or the viewer. */
export const sceneWords: Readonly<Record<string, SceneWords>> = {
  benchmarkLights: {
    label: 'Planes',
    help: 'N × N planes that make a floor of 30 m × 30 m, lights just above it.',
    axes: ['lights', 'objects', 'pixels', 'overdraw', 'kind', 'shading'],
  },
  sponza: {
    label: 'Atrium',
    help: 'A hall of the scale of the Sponza palace: 100 meshes, 260,000 triangles.',
    axes: lit,
  },
  temple: {
    label: 'Temple',
    help: 'A Doric temple on a green plane, with six spot lights beside the moving lights.',
    axes: lit,
  },
  own: {
    label: 'Your scene',
    help: 'The scene that the editor or the viewer handed over.',
    axes: ['pixels', 'shading'],
  },
};

/** Labels and units of the x axis of a chart, by axis. */
export const axisWords: Readonly<Record<Axis, { label: string; unit: string }>> = {
  lights: { label: 'Point lights', unit: 'lights' },
  objects: { label: 'Objects', unit: 'objects' },
  pixels: { label: 'Pixels of the picture', unit: 'pixels' },
  overdraw: { label: 'Layers one behind the other', unit: 'layers' },
  shadows: { label: 'Lights that cast shadows', unit: 'shadowed lights' },
  kind: { label: 'Kind of lights', unit: 'kind of lights' },
  shading: { label: 'Shading', unit: 'shading' },
};

/** Label of the x axis of a series, naming its kind of lights. */
export function axisLabel({ axis, cases }: Pick<LabSeries, 'axis' | 'cases'>): string {
  const others = axis === 'lights' && cases.some(({ lightKind }) => lightKind !== 'points');
  return t(others ? 'Lights' : axisWords[axis].label);
}
