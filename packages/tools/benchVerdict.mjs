import { caseName, digits } from './benchLabWords.mjs';

/**
 * @typedef {import('./benchLabBrowser.mjs').LabPlan} LabPlan
 * @typedef {import('./benchLabBrowser.mjs').LabRow} LabRow
 * @typedef {import('./benchLabBrowser.mjs').LabRun} LabRun
 *
 * @typedef {(number | null)[]} Figures frame, CPU and GPU (ms), draws, programs, first frame (ms), as in `columns`
 *
 * @typedef {object} Reached what was reached on one machine; apps/lab/reached.json
 * @property {string} device
 * @property {string} browser
 * @property {string} build
 * @property {string} date
 * @property {string} command
 * @property {Record<string, Figures>} cases by case and competitor
 *
 * @typedef {{ name: string, series: string, index: number, competitor: string, what: string, ratio: number }} Slower
 */

/** Suffix of a competitor's key that stands for the same competitor in the other build. */
export const AGAINST = '@against';

/** Titles of `Figures`. */
const columns = ['frame', 'CPU', 'GPU', 'draws', 'programs', 'first'];

/** Greatest ratio of a time to the same time of the other build that does not yet count as slower. */
const limits = { GPU: 1.02, CPU: 1.05 };
/** Difference of two times that the clock's resolution explains (ms). */
const STEP = 0.005;

/** Greatest loss of auto against the fastest technique (share of its frame time), in each case and on average. */
export const regretLimits = { each: 0.05, mean: 0.02 };

/** @param {LabRow | undefined} row @returns {Figures | null} null for a row without figures */
function figuresOf(row) {
  if (!row?.frame) return null;
  const { frame, cpu, gpu, counts, firstMs } = row;
  return [
    frame.median,
    cpu?.median ?? null,
    gpu?.median ?? null,
    counts?.draws ?? null,
    counts?.programs ?? null,
    firstMs,
  ];
}

/** Each case of a run with its rows. @param {Pick<LabRun, 'plan' | 'rows'>} run */
const casesOf = ({ plan, rows }) =>
  plan.series.flatMap((series) =>
    series.cases.map((_, index) => ({
      ...{ name: caseName(series, index), series: series.name, index },
      rows: rows.filter((row) => row.series === series.name && row.index === index),
    })),
  );

/**
 * Figures of a run as a table in Markdown: with two builds each is `this / other (ratio)`.
 *
 * @param {LabRun} run
 * @param {Reached | null} reached
 */
export function figuresTable(run, reached) {
  const names = run.plan.competitors.filter((name) => !name.endsWith(AGAINST));
  const titles = ['case', 'competitor', ...columns, ...(reached ? ['reached: frame, CPU, GPU'] : [])];
  const lines = casesOf(run).flatMap(({ name, rows }) =>
    names.flatMap((competitor) => {
      const of = (/** @type {string} */ key) => figuresOf(rows.find((row) => row.competitor === key));
      const [ours, theirs] = [of(competitor), of(`${competitor}${AGAINST}`)];
      if (!ours && !theirs) return [];
      const figures = columns.map((_, at) => compared(ours?.[at] ?? null, theirs && theirs[at]));
      const technique = rows.find((row) => row.competitor === competitor)?.technique ?? competitor;
      const drawn = technique === competitor ? '' : ` (${technique})`;
      const before = reached?.cases[`${name}: ${competitor}`];
      const old = reached ? [before ? before.slice(0, 3).map(digits).join(', ') : '–'] : [];
      return [tableLine([name, `${competitor}${drawn}`, ...figures, ...old])];
    }),
  );
  const place = reached
    ? [`Reached: ${reached.device}, ${reached.browser}, ${reached.build}, ${reached.date}.`, '']
    : [];
  return [...place, tableLine(titles), tableLine(titles.map((_, at) => (at < 2 ? ':--' : '--:'))), ...lines].join('\n');
}

/** @param {number | null} ours @param {number | null} theirs - null for one build */
function compared(ours, theirs) {
  if (theirs === null) return digits(ours);
  const ratio = ours !== null && theirs > 0 ? ` (${(ours / theirs).toFixed(3)})` : '';
  return `${digits(ours)} / ${digits(theirs)}${ratio}`;
}

/** @param {string[]} texts */
const tableLine = (texts) => `| ${texts.join(' | ')} |`;

/**
 * Cases in which this build is slower than the other by more than the limits.
 *
 * @param {Pick<LabRun, 'plan' | 'rows'>} run
 * @returns {Slower[]}
 */
export function slowerCases(run) {
  return casesOf(run).flatMap(({ name, series, index, rows }) =>
    rows.flatMap((row) => {
      const other = rows.find(({ competitor }) => competitor === `${row.competitor}${AGAINST}`);
      const [ours, theirs] = [figuresOf(row), figuresOf(other)];
      if (!ours || !theirs) return [];
      return Object.entries(limits).flatMap(([what, most]) => {
        const at = columns.indexOf(what);
        const [a, b] = [ours[at], theirs[at]];
        if (a === null || b === null || a - b <= STEP || a <= b * most) return [];
        return [{ name, series, index, competitor: row.competitor, what, ratio: a / b }];
      });
    }),
  );
}

/**
 * Plan of the cases and competitors that are to be measured again, for longer.
 *
 * @param {LabPlan} plan
 * @param {readonly Slower[]} slower
 * @returns {LabPlan}
 */
export function doubtfulPlan(plan, slower) {
  const isIn = (/** @type {string} */ name, /** @type {number} */ index) =>
    slower.some((each) => each.series === name && each.index === index);
  const series = plan.series.map((each) => ({
    ...each,
    cases: each.cases.filter((_, index) => isIn(each.name, index)),
    values: each.values.filter((_, index) => isIn(each.name, index)),
  }));
  return {
    ...plan,
    series: series.filter(({ cases }) => cases.length > 0),
    competitors: plan.competitors.filter((name) =>
      slower.some(({ competitor }) => name === competitor || name === `${competitor}${AGAINST}`),
    ),
    effort: { ...plan.effort, rounds: plan.effort.rounds * 2 },
  };
}

/**
 * Losses of `auto` against the fastest technique, case by case and on average, for cases that the CPU bounds and for those
 * that the GPU bounds.
 *
 * @param {LabRun} run
 * @returns {{ text: string, isWithin: boolean }} lines to print, and whether every case and the mean are within the limits
 */
export function regretReport(run) {
  const cases = casesOf(run).flatMap(({ name, rows }) => {
    const auto = rows.find(({ competitor }) => competitor === 'auto');
    const others = rows.filter(({ competitor, frame }) => competitor !== 'auto' && frame !== null);
    const [best] = others.sort((a, b) => ms(a) - ms(b));
    if (!auto?.frame || !best) return [];
    const chosen = others.find(({ competitor }) => competitor === auto.technique) ?? best;
    // auto draws by the technique that it chose: of two times of the same work, the lesser has less noise
    const regret = Math.min(ms(auto), ms(chosen)) / ms(best) - 1;
    const isCPU = auto.gpu === null || (auto.cpu?.median ?? 0) > auto.gpu.median;
    return [{ name, auto, best, isCPU, regret: Math.max(0, regret) }];
  });
  const part = (/** @type {string} */ title, /** @type {typeof cases} */ each) => {
    if (each.length === 0) return [];
    const sorted = [...each].sort((a, b) => b.regret - a.regret);
    const mean = each.reduce((sum, { regret }) => sum + regret, 0) / each.length;
    const lines = sorted.map(
      ({ name, auto, best, regret }) =>
        `${percent(regret).padStart(7)}  ${name}: auto ${digits(ms(auto))} (${auto.technique}), best ${digits(ms(best))} (${best.competitor}); CPU ${digits(auto.cpu?.median)}, GPU ${digits(auto.gpu?.median)}`,
    );
    return ['', `${title}: ${each.length} cases, mean ${percent(mean)}, worst ${percent(sorted[0].regret)}`, ...lines];
  };
  const lines = [
    ...part(
      'Bound by the CPU',
      cases.filter(({ isCPU }) => isCPU),
    ),
    ...part(
      'Bound by the GPU',
      cases.filter(({ isCPU }) => !isCPU),
    ),
  ];
  const mean = cases.reduce((sum, { regret }) => sum + regret, 0) / cases.length;
  const isWithin = mean <= regretLimits.mean && cases.every(({ regret }) => regret <= regretLimits.each);
  return { text: lines.join('\n'), isWithin };
}

/** Time of a frame (ms). @param {LabRow} row */
const ms = ({ frame }) => frame?.median ?? Number.NaN;

/** @param {number} share */
const percent = (share) => `${(100 * share).toFixed(1)}%`;

/**
 * Text for apps/lab/reached.json: figures of this build in a run, one line for each case and competitor.
 *
 * @param {LabRun} run
 * @param {Reached | null} before - whose other cases stay, if they are of this device
 */
export function reachedText(run, before) {
  const { device, browser, build, date } = run.surroundings;
  const command = run.surroundings.command?.replace(/ --(dist|out|against) \S+/g, '');
  const cases = { ...(before?.device === device ? before.cases : {}) };
  for (const { name, rows } of casesOf(run)) {
    for (const row of rows) {
      const figures = figuresOf(row);
      if (figures && row.warnings.length === 0 && !row.competitor.endsWith(AGAINST))
        cases[`${name}: ${row.competitor}`] = figures.map(
          (value) => value && (Number.isInteger(value) ? value : Number(value.toPrecision(3))),
        );
    }
  }
  const lines = Object.entries(cases).map(
    ([key, figures]) => `    ${JSON.stringify(key)}: [${figures.map((value) => JSON.stringify(value)).join(', ')}]`,
  );
  const place = Object.entries({ device, browser, build, date, command, figures: columns.join(', ') });
  const head = place.map(([key, value]) => `  ${JSON.stringify(key)}: ${JSON.stringify(value)},\n`).join('');
  return `{\n${head}  "cases": {\n${lines.join(',\n')}\n  }\n}\n`;
}
