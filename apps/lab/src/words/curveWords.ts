import { isNamed, type LabCase, type LabSeries } from '../plan/LabPlan';
import type { LabRun, Metric } from '../results/LabRun';
import { timeOf } from './compareSpreads';
import { findCrossing } from './crossing';
import { asClause, capital, formatFactor, formatMs, formatNumber, listOf } from './format';
import { competitorKind, competitorWord, metricWords, valueText } from './names';
import { costWords } from './costWords';
import { rowsOf } from './rowsOf';
import { type Winners, winnersOf, winningRanges } from './winners';

/**
 * What a series shows, as sentences: who is fastest where, where forward falls behind deferred, how far the other
 * renderers are, who cannot draw and why. Empty spreads, ties and missing figures are said, not guessed.
 */
export function curveWords(run: LabRun, series: LabSeries, metric: Metric): string[] {
  const winners = series.cases.flatMap((_, index) => winnersOf(run, series, index, metric) ?? []);
  if (winners.length === 0) return nothing(run, series, metric);
  const everybody = new Set(winners.flatMap(({ entries }) => entries.map(({ competitor }) => competitor)));
  return [
    everybody.size === 1 ? alone(series, winners, metric) : fastest(series, winners, metric),
    ...(isNamed(series.axis) ? costWords(series, winners) : [behind(run, series, metric, 'forward', 'deferred')]),
    distance(series, winners),
    ...refusals(run, series),
    doubts(run, series),
  ].filter((sentence) => sentence !== '');
}

/** Text of a case's value before another that has the unit: `10` of `10 to 50 lights`. */
function withoutUnit(series: LabSeries, { index, value }: { index: number; value: number }): string {
  return series.axis === 'pixels' ? at(series, { index, value }) : formatNumber(value, 6);
}

/** Text of a case's value. */
function at(series: LabSeries, { index, value }: { index: number; value: number }): string {
  return valueText(series.axis, value, series.cases[index]);
}

function nothing(run: LabRun, series: LabSeries, metric: Metric): string[] {
  const reasons = refusals(run, series);
  if (metric !== 'frame' && series.cases.some((_, index) => winnersOf(run, series, index, 'frame'))) {
    return [`No ${metricWords[metric].noun} was measured here${metric === 'gpu' ? ': the device has no timer' : ''}.`];
  }
  return reasons.length > 0 ? reasons : ['Nothing has been measured here yet.'];
}

/** How a sentence on another time than that of frames begins. */
function opening(metric: Metric): string {
  return metric === 'frame' ? '' : `by ${metricWords[metric].noun} `;
}

function alone(series: LabSeries, winners: readonly Winners[], metric: Metric): string {
  const first = winners[0];
  const last = winners.at(-1)!;
  const name = capital(opening(metric) + competitorWord(first.best.competitor));
  const start = `${name} alone has figures: ${formatMs(first.best.time.median)} with ${at(series, first)}`;
  return last === first ? `${start}.` : `${start}, ${formatMs(last.best.time.median)} with ${at(series, last)}.`;
}

function fastest(series: LabSeries, winners: readonly Winners[], metric: Metric): string {
  const whole = winningRanges(winners);
  // between two names there is nothing
  const ranges =
    isNamed(series.axis) && whole.length > 1 ? winners.map((each) => ({ names: each.names, cases: [each] })) : whole;
  const time = (name: string, each: Winners): string =>
    formatMs(each.entries.find(({ competitor }) => competitor === name)!.time.median);
  const parts = ranges.map(({ names, cases }, place) => {
    const first = cases[0];
    const last = cases.at(-1)!;
    const shown = names.slice(0, 3).map(competitorWord);
    const more = names.length > 3 ? [`${names.length - 3} more`] : [];
    const who = listOf([...shown, ...more]);
    // alone in some cases, tied with others in the rest
    const mixed = names.length === 1 && cases.some((each) => each.names.length > 1);
    const before = ranges[place - 1];
    const isPlain = names.length === 1 && !mixed && before?.cases.every((each) => each.names.length === 1);
    const verb = names.length > 1 ? 'tie for the fastest' : mixed ? 'is the fastest or ties for it' : 'is the fastest';
    const says = isPlain ? who : `${who} ${verb}`;
    const joint = place === 0 ? '' : isPlain ? ', ' : '; ';
    if (first === last) return `${joint}${says} with ${at(series, first)} (${time(names[0], first)})`;
    const whole = ranges.length === 1 && cases.length === winners.length;
    if (!whole) {
      const where = `from ${withoutUnit(series, first)} to ${at(series, last)}`;
      return `${joint}${says} ${where} (${time(names[0], last)} there)`;
    }
    // what each case costs is the next sentence
    if (isNamed(series.axis)) return `${says} throughout`;
    const figures = `${time(names[0], first)} with ${at(series, first)}, ${time(names[0], last)} with ${at(series, last)}`;
    return `${says} throughout: ${figures}`;
  });
  return `${capital(opening(metric) + parts.join(''))}.`;
}

/** Where one competitor falls behind another, and by how much in the end. */
export function behind(run: LabRun, series: LabSeries, metric: Metric, slow: string, quick: string): string {
  const rows = rowsOf(run, series);
  const pairs = series.values.flatMap((value, index) => {
    const a = timeOf(rows.get(slow)?.[index], metric);
    const b = timeOf(rows.get(quick)?.[index], metric);
    return a && b ? [{ value, index, a, b }] : [];
  });
  if (pairs.length < 2) return '';
  const last = pairs.at(-1)!;
  const names = [capital(competitorWord(slow)), competitorWord(quick)];
  const factor = last.a.median / last.b.median;
  const end =
    factor > 1
      ? `takes ${formatFactor(factor)} as long with ${at(series, last)}`
      : `is still ${formatFactor(1 / factor)} as fast with ${at(series, last)}`;
  const crossing = findCrossing(pairs);
  switch (crossing.kind) {
    case 'from': {
      const unit = valueText(series.axis, 2).replace(/^2 /, '');
      const about = `about ${formatNumber(crossing.at, 2)} ${unit}`;
      const between = `between ${formatNumber(crossing.before, 6)} and ${formatNumber(crossing.after, 6)}`;
      return `${names[0]} falls behind ${names[1]} from ${about} on (${between} measured), and ${end}.`;
    }
    case 'always':
      return crossing.first === pairs[0].value
        ? `${names[0]} is behind ${names[1]} already with ${at(series, pairs[0])}, and ${end}.`
        : `${names[0]} and ${names[1]} tie at first; ${names[0].toLowerCase()} falls behind by ${valueText(series.axis, crossing.first)}, and ${end}.`;
    case 'never':
      return crossing.ahead
        ? `${names[0]} never falls behind ${names[1]} here: it ${end}.`
        : `${names[0]} and ${names[1]} cannot be told apart here: their spreads overlap.`;
    case 'mixed':
      return `${names[0]} and ${names[1]} change places more than once: ${names[0].toLowerCase()} is ahead with ${numbers(crossing.ahead, series)}, behind with ${numbers(crossing.behind, series)}.`;
    default:
      return '';
  }
}

function numbers(values: readonly number[], series: LabSeries): string {
  return `${listOf(
    values
      .slice(0, -1)
      .map((value) => formatNumber(value, 6))
      .concat(valueText(series.axis, values.at(-1)!)),
  )}`;
}

/** How far three's renderers and other engines are from the fastest of Farol's, each in the last case that both draw. */
function distance(series: LabSeries, winners: readonly Winners[]): string {
  const parts: string[] = [];
  let told = '';
  for (const kind of ['three', 'rival'] as const) {
    for (const each of winners.toReversed()) {
      const other = each.entries.find(({ competitor }) => competitorKind(competitor) === kind);
      const ours = each.entries.find(({ competitor }) => competitorKind(competitor) === 'farol');
      if (!other || !ours) continue;
      const factor = other.time.median / ours.time.median;
      const compared = factor >= 1 ? `${formatFactor(factor)} as long` : `${formatFactor(1 / factor)} as fast`;
      const start = `with ${at(series, each)} ${competitorWord(ours.competitor)} takes ${formatMs(ours.time.median)}`;
      const rest = `${competitorWord(other.competitor)} ${formatMs(other.time.median)} (${compared})`;
      parts.push(start === told ? rest : `${start}, ${rest}`);
      told = start;
      break;
    }
  }
  return parts.length === 0 ? '' : `${capital(parts.join('; '))}.`;
}

/** Who cannot draw, from which value on, and why: one sentence for each reason, three at most. */
export function refusals(run: LabRun, series: LabSeries): string[] {
  const byReason = new Map<string, string[]>();
  for (const [competitor, rows] of rowsOf(run, series)) {
    const refused = rows.flatMap((row, index) => (row?.problem ? [{ index, reason: asClause(row.problem) }] : []));
    if (refused.length === 0) continue;
    const { index, reason } = refused[0];
    const measured = rows.filter(Boolean).length;
    const isList = isNamed(series.axis);
    const onwards = !isList && rows.slice(index).every((row) => row === undefined || row.problem !== null);
    const from = { index, value: series.values[index] };
    const where =
      refused.length === measured
        ? ' in any case'
        : onwards && refused.length > 1
          ? ` from ${at(series, from)} on`
          : ` with ${listOf(refused.slice(0, isList ? undefined : 1).map((each) => at(series, { ...each, value: series.values[each.index] })))}`;
    const key = `${where}: ${reason}.`;
    byReason.set(key, [...(byReason.get(key) ?? []), competitorWord(competitor)]);
  }
  const everybody = run.plan.competitors.length;
  const sentences = [...byReason].map(([key, who]) =>
    who.length > 1 && who.length === everybody ? `No figure${key}` : `No figure for ${listOf(who)}${key}`,
  );
  const more = sentences.length - 3;
  const rest = more === 1 ? 'One more reason stands in the table.' : `${more} more reasons stand in the table.`;
  return more > 0 ? [...sentences.slice(0, 3), rest] : sentences;
}

/** How many figures carry a warning. */
function doubts(run: LabRun, series: LabSeries): string {
  const doubtful = run.rows.filter(
    (row) => row.series === series.name && row.problem === null && row.warnings.length > 0,
  );
  if (doubtful.length === 0) return '';
  const [first] = doubtful;
  const count = doubtful.length === 1 ? 'One figure is doubtful,' : `${doubtful.length} figures are doubtful, such as`;
  return `${count} ${competitorWord(first.competitor)}’s with ${at(series, { index: first.index, value: series.values[first.index] })}: ${asClause(first.warnings[0])}.`;
}

/** The case's size, for titles: `1280 × 720`; empty where the series has several. */
export function sizeText(cases: readonly LabCase[]): string {
  // no line ends within a size
  const sizes = new Set(cases.map(({ width, height }) => `${width}\u00a0×\u00a0${height}`));
  return sizes.size === 1 ? [...sizes][0] : '';
}
