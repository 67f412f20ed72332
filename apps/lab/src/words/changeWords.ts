import type { Change, LabRow } from '../results/LabRun';
import { timeOf } from './compareSpreads';
import { capital, formatFactor, formatMs, listOf } from './format';
import { competitorWord } from './names';

/** Whether a time after a change is there. */
export function changeOf(change: Change | null): Change | null {
  return change !== null && Number.isFinite(change.ms) && change.ms > 0 ? change : null;
}

/** What changes cost in one case: the longest first frame, who compiles anew for ten lights more, and how long it takes. */
export function changeWords(rows: readonly LabRow[]): string[] {
  const sentences: string[] = [];
  const firsts = rows.filter(({ firstMs }) => firstMs !== null && firstMs > 0).sort((a, b) => a.firstMs! - b.firstMs!);
  if (firsts.length > 1) {
    const [least, most] = [firsts[0], firsts.at(-1)!];
    sentences.push(
      `The first frame takes ${formatMs(least.firstMs!)} (${competitorWord(least.competitor)}) to ${formatMs(most.firstMs!)} (${competitorWord(most.competitor)}).`,
    );
  }
  const added = rows.flatMap((row) => {
    const change = changeOf(row.added);
    return change ? [{ row, change }] : [];
  });
  const compiling = added.filter(({ change }) => (change.programs ?? 0) > 0).sort((a, b) => b.change.ms - a.change.ms);
  const known = added.filter(({ change }) => change.programs !== null);
  if (compiling.length > 0) {
    const parts = compiling.slice(0, 3).map(({ row, change }) => {
      const usual = timeOf(row, 'frame');
      const times = usual ? `, ${formatFactor(change.ms / usual.median)} an ordinary frame` : '';
      const programs = change.programs === 1 ? 'one program' : `${change.programs} programs`;
      return `${competitorWord(row.competitor)} links ${programs} (${formatMs(change.ms)}${times})`;
    });
    const others =
      known.length > compiling.length
        ? `; the others${known.length < added.length ? ' that are counted' : ''} link none`
        : '';
    sentences.push(`For ten lights more ${listOf(parts)}${others}.`);
  } else if (known.length > 1) {
    const most = known.reduce((a, b) => (b.change.ms > a.change.ms ? b : a));
    sentences.push(
      `Nobody links a program for ten lights more; the longest frame is ${competitorWord(most.row.competitor)}’s (${formatMs(most.change.ms)}).`,
    );
  } else if (known.length === 1) {
    const [{ row, change }] = known;
    sentences.push(
      `${capital(competitorWord(row.competitor))} links no program for ten lights more: ${formatMs(change.ms)}.`,
    );
  }
  const changed = rows.flatMap((row) => (changeOf(row.changed) ? [{ row, ms: row.changed!.ms }] : []));
  if (changed.length > 0) {
    const most = changed.reduce((a, b) => (b.ms > a.ms ? b : a));
    sentences.push(
      `The longest frame after a change of technique is the one to ${competitorWord(most.row.competitor)} (${formatMs(most.ms)}).`,
    );
  }
  return sentences.length > 0 ? sentences : ['No frames after changes were measured here.'];
}
