import type { Command } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import type { Arrangement } from '../arrange/Arrangement';
import { arrangedPlaces } from '../arrange/arrangedPlaces';
import { arrangeObjects } from '../arrange/arrangeObjects';
import { topmost } from '../commands/Placement';
import { below, pick, type Random } from './random';

/** Settings of an arrangement: by default a line of five, 1 m apart. */
export const arrangement = (settings: Partial<Arrangement> = {}): Arrangement => ({
  kind: 'line',
  count: 5,
  offset: [1, 0, 0],
  radius: 3,
  arc: 2 * Math.PI,
  turns: false,
  counts: [2, 1, 2],
  spacing: [1, 1, 1],
  minimumDistance: 0,
  upwards: true,
  aligns: false,
  randomTurn: false,
  sizeVariation: 0,
  follows: false,
  height: 0,
  seed: 1,
  colours: 'same',
  sharesLight: false,
  intensityVariation: 0,
  rangeVariation: 0,
  grouped: false,
  ...settings,
});

/** Copies objects in a random arrangement, often in a group, with varied lights. */
export function randomArrangement(random: Random, scene: Scene, objects: readonly GameObject[]): Command {
  const settings = arrangement({
    kind: pick(random, ['line', 'ring', 'grid'] as const),
    count: 1 + below(random, 4),
    offset: [random(), random(), random()],
    turns: random() < 0.5,
    colours: pick(random, ['same', 'random', 'rainbow'] as const),
    intensityVariation: random() < 0.5 ? 0 : 0.5,
    rangeVariation: random() < 0.5 ? 0 : 0.5,
    grouped: random() < 0.5,
  });
  const origins = topmost(objects, scene).map(({ transform }) => transform.worldPosition.toArray());
  return arrangeObjects(scene, objects, arrangedPlaces(settings, origins), settings);
}
