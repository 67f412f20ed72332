import { digits } from './benchTable.mjs';

/** @typedef {import('./benchLabBrowser.mjs').LabRow} LabRow */

/**
 * One line for a case that has ended, the fastest competitor first.
 *
 * @param {{ label: string, axis: string, values: number[], cases: object[] }} series
 * @param {number} index - of the case
 * @param {readonly LabRow[]} rows - of the case
 */
export function runLine({ label, axis, values, cases }, index, rows) {
  const there = rows.flatMap(({ competitor, frame }) => (frame ? [{ competitor, ms: frame.median }] : []));
  const figures = there.sort((a, b) => a.ms - b.ms).map(({ competitor, ms }) => `${competitor} ${digits(ms)}`);
  const without = rows.filter(({ frame }) => frame === null).map(({ competitor }) => competitor);
  const missing = without.length > 0 ? `; no figure: ${without.join(', ')}` : '';
  const { lightKind, shading } = /** @type {{ lightKind?: string, shading?: string }} */ (cases[index]);
  // the values of these axes are indices into lists of names
  const name = axis === 'kind' ? lightKind : axis === 'shading' ? shading : undefined;
  const unit = values[index] === 1 ? axis.replace(/s$/, '') : axis;
  return `${label}, ${name ?? `${values[index].toLocaleString('en')} ${unit}`}: ${figures.length > 0 ? `${figures.join(', ')} ms` : 'nothing'}${missing}`;
}

/** Time left, after a comma; empty if unknown. @param {number | null} ms */
export function remainingMinutes(ms) {
  if (ms === null) return '';
  const seconds = Math.max(1, Math.round(ms / 1000));
  return seconds < 90 ? `, ${seconds} s left` : `, ${Math.round(seconds / 60)} min left`;
}
