/** @typedef {Pick<import('./benchLabBrowser.mjs').LabRow, 'competitor' | 'frame'>} LabRow */
/** @typedef {Omit<import('./benchLabBrowser.mjs').LabSeries, 'name'>} LabSeries */

/** A number with about three digits; a dash for none. @param {number | null | undefined} value */
export function digits(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  return value.toFixed(
    size >= 100 || Number.isInteger(value) ? 0 : size >= 10 ? 1 : size >= 0.095 || size === 0 ? 2 : 3,
  );
}

/**
 * One line for a case that has ended, the fastest competitor first.
 *
 * @param {LabSeries} series
 * @param {number} index - of the case
 * @param {readonly LabRow[]} rows - of the case
 */
export function runLine(series, index, rows) {
  const there = rows.flatMap(({ competitor, frame }) => (frame ? [{ competitor, ms: frame.median }] : []));
  const figures = there.sort((a, b) => a.ms - b.ms).map(({ competitor, ms }) => `${competitor} ${digits(ms)}`);
  const without = rows.filter(({ frame }) => frame === null).map(({ competitor }) => competitor);
  const missing = without.length > 0 ? `; no figure: ${without.join(', ')}` : '';
  return `${caseName(series, index)}: ${figures.length > 0 ? `${figures.join(', ')} ms` : 'nothing'}${missing}`;
}

/** Name of a case: its series and its value along the axis. @param {LabSeries} series @param {number} index - of the case */
export function caseName({ label, axis, values, cases }, index) {
  const { lightKind, shading } = /** @type {{ lightKind?: string, shading?: string }} */ (cases[index]);
  // the values of these axes are indices into lists of names
  const name = axis === 'kind' ? lightKind : axis === 'shading' ? shading : undefined;
  const unit = values[index] === 1 ? axis.replace(/s$/, '') : axis;
  return `${label}, ${name ?? `${values[index].toLocaleString('en')} ${unit}`}`;
}

/** Time left, after a comma; empty if unknown. @param {number | null} ms */
export function remainingMinutes(ms) {
  if (ms === null) return '';
  const seconds = Math.max(1, Math.round(ms / 1000));
  return seconds < 90 ? `, ${seconds} s left` : `, ${Math.round(seconds / 60)} min left`;
}
