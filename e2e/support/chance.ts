import { test } from '@playwright/test';
import type { ChangesFault } from '../pages/chance/runChanges';
import type { ChanceFault, ChanceResult } from '../pages/chance/runScenes';
import { recordComparison } from './comparison';

/** Type of the annotation that a fault of a scene by chance is left in, as JSON. */
export const CHANCE = 'scene by chance';

/** Number of scenes and seed of `npm run agree -- --chance N --seed n`; null in any other run of the tests. */
export function askedScenes(): { readonly count: number; readonly seed: number } | null {
  const { FAROL_CHANCE: count, FAROL_CHANCE_SEED: seed = '0' } = process.env;
  return count ? { count: Number(count), seed: Number(seed) } : null;
}

/** Whole numbers from `first` on, in the decks that they fall into. */
export function decksOf(first: number, count: number, size: number): number[][] {
  const decks = new Map<number, number[]>();
  for (let seed = first; seed < first + count; seed++) {
    const deck = Math.floor(seed / size);
    decks.set(deck, [...(decks.get(deck) ?? []), seed]);
  }
  return [...decks.values()];
}

/** Leaves pictures and faults in the report of the running test. @param excused - technique and seed of known faults */
export function recordScenes(result: ChanceResult, excused: (seed: number, technique: string) => boolean): void {
  for (const { seed, good, technique, ...difference } of result.pictures)
    recordComparison({
      suite: 'chance',
      technique,
      name: `seed ${seed}`,
      good,
      exception: !good && excused(seed, technique),
      ...difference,
    });
  const notes = test.info().annotations;
  for (const fault of result.faults) notes.push({ type: CHANCE, description: JSON.stringify(fault) });
  for (const { seed, why } of result.unseen) notes.push({ type: CHANCE, description: JSON.stringify({ seed, why }) });
}

/** Leaves faults of scenes that change in the report of the running test. */
export function recordChanges(faults: readonly ChangesFault[]): void {
  for (const { seed, technique, fault, changes, isLeftOver } of faults) {
    const names = new Set(changes.map((change) => change.split(' ')[1]));
    const kind = `changes${isLeftOver ? ' from frame to frame' : ''}: ${[...names].toSorted().join(', ')}`;
    const description = JSON.stringify({
      seed,
      techniques: [technique],
      fault,
      facts: changes,
      kind,
      isLeftOver: false,
    });
    test.info().annotations.push({ type: CHANCE, description });
  }
}

/** Faults and scenes that said nothing, by kind, as lines to print: the most frequent first. */
export function scenesByKind(notes: readonly string[]): string[] {
  const kinds = new Map<string, ChanceFault[]>();
  const unseen = new Map<string, number[]>();
  for (const note of notes) {
    const { why, ...fault } = JSON.parse(note) as ChanceFault & { why?: string };
    if (why !== undefined) {
      unseen.set(why, [...(unseen.get(why) ?? []), fault.seed]);
      continue;
    }
    const kind = fault.isLeftOver ? 'only after other scenes' : (fault.kind ?? 'not shrunk');
    kinds.set(kind, [...(kinds.get(kind) ?? []), fault]);
  }
  const lines = [...kinds]
    .sort(([, a], [, b]) => b.length - a.length)
    .flatMap(([kind, faults]) => {
      const least = faults.toSorted((a, b) => JSON.stringify(a.facts).length - JSON.stringify(b.facts).length)[0];
      return [
        `\n${faults.length} × ${kind}: seeds ${faults.map(({ seed }) => seed).join(' ')}`,
        `  ${least.techniques.join(' ')}: ${least.fault}`,
        `  ${JSON.stringify(least.facts)}`,
      ];
    });
  for (const [why, seeds] of unseen) lines.push(`\nnot compared, ${why}: seeds ${seeds.join(' ')}`);
  return lines;
}
