/**
 * @typedef {import('./benchCases.mjs').BenchCase} BenchCase
 * @typedef {import('./benchStatistics.mjs').Summary} Summary
 * @typedef {import('./benchStatistics.mjs').Change} Change
 *
 * @typedef {{ summary: Summary | null, error: string | null }} Outcome neither when it was not measured
 * @typedef {{ benchCase: BenchCase, outcomes: (Outcome | null)[] }} Row one outcome a build; null where it lacks the case
 *
 * @typedef {object} Heading
 * @property {string} date
 * @property {string[]} builds names; two of them make a comparison
 * @property {string} renderer the graphics device, as WebGL names it
 * @property {string} browser
 * @property {number} rounds that were measured
 */

/** @type {[title: string, pick: (summary: Summary) => number | null, unit: 'ms' | 'count' | 'kB'][]} */
const columns = [
  ['GPU ms', ({ gpu }) => gpu?.median ?? null, 'ms'],
  ['p95', ({ gpu }) => gpu?.p95 ?? null, 'ms'],
  ['CPU ms', ({ cpu }) => cpu?.median ?? null, 'ms'],
  ['p95', ({ cpu }) => cpu?.p95 ?? null, 'ms'],
  ['frame ms', ({ frame }) => frame?.median ?? null, 'ms'],
  ['p95', ({ frame }) => frame?.p95 ?? null, 'ms'],
  ['batch ms', ({ batch }) => batch?.median ?? null, 'ms'],
  ['draws', ({ draws }) => draws, 'count'],
  ['programs', ({ programs }) => programs, 'count'],
  ['upload kB', ({ uploadBytes }) => uploadBytes / 1000, 'kB'],
  ['targets MB', ({ targetBytes }) => targetBytes / 1e6, 'kB'],
  ['first ms', ({ firstMs }) => firstMs, 'ms'],
];

/** A number with about three digits; a dash for none. @param {number | null | undefined} value */
export function digits(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  return value.toFixed(
    size >= 100 || Number.isInteger(value) ? 0 : size >= 10 ? 1 : size >= 0.095 || size === 0 ? 2 : 3,
  );
}

/**
 * The results as markdown: a table for each scene and size. With two builds each figure is `this / that (ratio)`.
 *
 * @param {Heading} heading
 * @param {readonly Row[]} rows
 */
export function benchTable({ date, builds, renderer, browser, rounds }, rows) {
  const lines = [
    `# Farol benchmark, ${date}`,
    '',
    `${renderer}, Chromium ${browser}, ${rounds} ${rounds === 1 ? 'round' : 'rounds'} in turns.`,
    '',
    'Times are medians of the rounds’ medians, p95 over the frames of all rounds. Frame: one frame that is waited for; ' +
      'batch: one of many that are waited for together; CPU: in `render`. Upload: in a frame whose lights move. ' +
      'After lights came or went: the next frame, over an ordinary one, and the programs compiled in it.',
    ...(builds.length > 1 ? ['', `Each figure: ${builds.join(' / ')} (ratio).`] : []),
  ];
  let title = '';
  for (const row of rows) {
    const { scene, size } = row.benchCase;
    const next = `${scene}, ${size.width}×${size.height}`;
    if (next !== title) {
      const titles = ['lights', 'technique', ...columns.map(([name]) => name), 'lights come', 'lights go'];
      lines.push('', `## ${next}`, '', line(titles), line(titles.map((_, at) => (at === 1 ? ':--' : '--:'))));
      title = next;
    }
    lines.push(line(cells(row)));
  }
  return `${lines.join('\n')}\n`;
}

/** @param {string[]} texts */
const line = (texts) => `| ${texts.join(' | ')} |`;

/** @param {Row} row */
function cells({ benchCase, outcomes }) {
  const { lights, technique } = benchCase;
  const summaries = outcomes.map((outcome) => outcome?.summary ?? null);
  const picked = [...new Set(summaries.map((summary) => summary?.technique))].filter(
    (name) => name && name !== technique,
  );
  const name = picked.length > 0 ? `${technique} (${picked.join(', ')})` : technique;
  const start = [String(lights ?? summaries.find(Boolean)?.lights ?? '–'), name];
  const errors = [...new Set(outcomes.flatMap((outcome) => outcome?.error ?? []))];
  if (summaries.every((summary) => summary === null)) {
    const text = errors.length > 0 ? errors.map(cellText).join('; ') : 'not measured';
    return [...start, text, ...columns.slice(1).map(() => ''), '', ''];
  }
  const figures = columns.map(([, pick]) => compared(summaries.map((summary) => (summary ? pick(summary) : null))));
  const changes = (/** @type {(summary: Summary) => Change | null} */ pick) =>
    summaries.map((summary) => changeText(summary ? pick(summary) : null)).join(' / ');
  const note = errors.length > 0 ? ` ⚠ ${errors.map(cellText).join('; ')}` : '';
  return [start[0], start[1] + note, ...figures, changes(({ added }) => added), changes(({ removed }) => removed)];
}

/** @param {(number | null)[]} values - one a build */
function compared(values) {
  if (values.length === 1 || values.every((value) => value === null)) return digits(values[0]);
  const [ours, theirs] = values;
  const ratio = ours !== null && theirs !== null && theirs > 0 ? ` (${digits(ours / theirs)})` : '';
  return `${values.map(digits).join(' / ')}${ratio}`;
}

/** @param {Change | null} change */
function changeText(change) {
  if (change === null) return '–';
  const times = change.ms === null ? '' : `${digits(change.ms)} ms, ×${digits(change.ratio)}, `;
  return `${times}${change.programs} pr.`;
}

/** @param {string} text - an error's, kept to one cell */
function cellText(text) {
  const oneLine = text.replaceAll(/\s+/g, ' ').replaceAll('|', '\\|');
  return oneLine.length > 160 ? `${oneLine.slice(0, 159)}…` : oneLine;
}
