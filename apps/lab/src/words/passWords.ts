import type { LabRow } from '../results/LabRun';
import { capital, formatMs, formatMsRange, formatPercent } from './format';
import { competitorWord } from './names';

/** Milliseconds of all passes of a row. */
export function passTotal(row: LabRow): number {
  return (row.passes?.passes ?? []).reduce((sum, { ms }) => sum + (Number.isFinite(ms) ? ms : 0), 0);
}

/** Where the frame of the quickest and of the slowest goes, by the passes of a case. */
export function passWords(rows: readonly LabRow[]): string[] {
  const sorted = rows.filter((row) => passTotal(row) > 0).sort((a, b) => passTotal(a) - passTotal(b));
  if (sorted.length === 0) return ['No times of passes were measured here.'];
  const kind = sorted[0].passes!.kind === 'gpu' ? 'GPU' : 'CPU';
  const [first, last] = [sorted[0], sorted.at(-1)!];
  const sentences = [`${mostOf(first, kind)}.`];
  if (first !== last) {
    sentences.push(
      `${mostOf(last, kind)}: ${formatMs(passTotal(last) - passTotal(first))} more in all than ${competitorWord(first.competitor)}.`,
    );
  }
  const buffers = sorted.flatMap(({ passes }) =>
    passes!.passes.filter(({ name, ms }) => /g-?buffer/i.test(name) && Number.isFinite(ms)).map(({ ms }) => ms),
  );
  if (buffers.length > 0) {
    const who = buffers.length === 1 ? 'The G-buffer takes' : 'G-buffers take';
    sentences.push(`${who} ${formatMsRange(buffers)}.`);
  }
  return sentences;
}

function mostOf(row: LabRow, kind: string): string {
  const total = passTotal(row);
  const most = row.passes!.passes.filter(({ ms }) => ms > 0).reduce((a, b) => (b.ms > a.ms ? b : a));
  return `${capital(competitorWord(row.competitor))} spends ${formatPercent(most.ms / total)} of ${formatMs(total)} ${kind} time in “${most.name}”`;
}
