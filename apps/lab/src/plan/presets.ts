import { competitorNames } from '../competitors/competitorNames';
import type { Configuration, SeriesChoice } from './Configuration';
import type { Effort } from './LabPlan';
import { type LightKind, lightKindNames, type Shading, shadingNames } from './lightKinds';

/** A ready-made configuration. */
export interface Preset {
  readonly label: string;
  readonly help: string;
  readonly configuration: Configuration;
}

/** Keys of all competitors except other engines, which are installed on demand, and 'lite', whose picture differs. */
export const ordinaryCompetitors: readonly string[] = Object.entries(competitorNames)
  .filter(([name, { kind }]) => kind !== 'rival' && name !== 'lite')
  .map(([name]) => name);

const thorough: Effort = { rounds: 3, turn: 400, changes: false, longestFrame: 10_000, limit: null };

/** A series over the number of lights in a scene. */
const overLights = (scene: string, values: readonly number[], n = 1): SeriesChoice => ({
  ...{ scene, n, axis: 'lights', values, lights: 0 },
});

/** A series over kinds of lights, in the atrium. */
const overKinds = (kinds: readonly LightKind[], lights: number, lightRange: number): SeriesChoice => ({
  ...{ scene: 'sponza', n: 1, axis: 'kind', values: kinds.map((kind) => lightKindNames.indexOf(kind)) },
  ...{ lights, lightRange },
});
const overShadings = (names: readonly Shading[], lights: number): SeriesChoice => ({
  ...{ scene: 'sponza', n: 1, axis: 'shading', values: names.map((name) => shadingNames.indexOf(name)), lights },
});

function preset(label: string, help: string, series: readonly SeriesChoice[], changes: Partial<Configuration> = {}) {
  const size = { width: 1280, height: 720 };
  return (name: string): Preset => ({
    label,
    help,
    configuration: { preset: name, series, ...size, competitors: ordinaryCompetitors, effort: thorough, ...changes },
  });
}

const recipes: Record<string, (name: string) => Preset> = {
  quick: preset(
    'Quick',
    'Planes and the atrium, from few lights to a thousand, by every technique.',
    [overLights('benchmarkLights', [4, 100]), overLights('sponza', [10, 100, 1000])],
    { effort: { rounds: 3, turn: 110, changes: true, longestFrame: 2000, limit: 80_000 } },
  ),
  thesis: preset('The thesis', 'The measurements of 2015 by the thesis that Farol grew from, row by row.', [
    overLights('benchmarkLights', [1, 4, 25, 100, 225]),
    { scene: 'benchmarkLights', n: 1, axis: 'objects', values: [4, 25, 100, 225], lights: 'objects' },
    overLights('sponza', [10, 20, 50, 100, 200, 500]),
    overLights('temple', [10, 20, 50, 100, 200, 500]),
  ]),
  lights: preset('Lights', 'From ten lights to ten thousand, in the atrium and the temple.', [
    overLights('sponza', [10, 30, 100, 300, 1000, 3000, 10_000]),
    overLights('temple', [10, 100, 1000]),
  ]),
  objects: preset('Objects', 'One plane to 2,500 under 100 lights.', [
    { scene: 'benchmarkLights', n: 1, axis: 'objects', values: [1, 25, 100, 400, 900, 2500], lights: 100 },
  ]),
  resolution: preset('Resolution', 'The atrium from 640 × 360 to 3840 × 2160, with few and with many lights.', [
    { scene: 'sponza', n: 1, axis: 'pixels', values: [230, 922, 2074, 8294], lights: 20 },
    { scene: 'sponza', n: 1, axis: 'pixels', values: [230, 922, 2074, 8294], lights: 500 },
  ]),
  overdraw: preset('Overdraw', 'Layers one behind the other, from back to front, under 100 lights.', [
    { scene: 'benchmarkLights', n: 1, axis: 'overdraw', values: [1, 2, 4, 8, 16], lights: 100 },
  ]),
  shadows: preset('Shadows', 'The atrium with 64 lights, of which more and more cast shadows.', [
    { scene: 'sponza', n: 1, axis: 'shadows', values: [0, 1, 4, 16, 64], lights: 64 },
  ]),
  matter: preset(
    'Light and matter',
    'In the atrium: particles and fields of thousands of lights, rectangles beside points, flat, Gouraud and Phong shading.',
    [
      { ...overLights('sponza', [20_000]), lightKind: 'particles' },
      { ...overLights('sponza', [10_000, 20_000]), lightKind: 'field', lightRange: 1 },
      overKinds(['points', 'field'], 5000, 2),
      overKinds(['points', 'rectangles'], 1000, 2),
      overShadings(['flat', 'gouraud', 'phong'], 100),
    ],
  ),
  regression: preset(
    'Regression',
    'The cases by which commits are compared: planes and the atrium from one light to 20,000, fields, shadows.',
    [
      overLights('benchmarkLights', [1]),
      overLights('benchmarkLights', [1, 225], 15),
      overLights('benchmarkLights', [1], 70),
      { ...overLights('sponza', [1, 10, 100, 500, 1000, 2000]), lightRange: 5 },
      { ...overLights('sponza', [10_000, 20_000]), lightRange: 1 },
      { ...overLights('sponza', [10_000, 20_000]), lightKind: 'field', lightRange: 1 },
      { scene: 'sponza', n: 1, axis: 'shadows', values: [64], lights: 64 },
    ],
    {
      competitors: ['auto', 'deferred', 'tiled-deferred', 'stock'],
      effort: { rounds: 5, turn: 300, changes: false, longestFrame: 4000, limit: null },
    },
  ),
  changes: preset(
    'What a change costs',
    'First frames, ten lights more, another technique: the longest frame, and what is compiled in it.',
    [overLights('sponza', [10, 100, 1000])],
    { effort: { rounds: 1, turn: 150, changes: true, longestFrame: 20_000, limit: null } },
  ),
};

/** Ready-made configurations by key. */
export const presets: Readonly<Record<string, Preset>> = Object.fromEntries(
  Object.entries(recipes).map(([name, make]) => [name, make(name)]),
);

/**
 * Configuration of the quick run. On a software rasteriser, where a frame of the atrium takes a second, it has small
 * pictures, mostly of the planes.
 */
export function quickFor({ software }: { software: boolean }): Configuration {
  const { configuration } = presets.quick;
  if (!software) return configuration;
  const series = [overLights('benchmarkLights', [1, 25, 100]), overLights('sponza', [10])];
  return { ...configuration, series, width: 240, height: 135 };
}
