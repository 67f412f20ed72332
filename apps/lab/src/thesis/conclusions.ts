import type { LabRun, Spread } from '../results/LabRun';
import { boundsOf, compareSpreads, SAME } from '../words/compareSpreads';
import { capital, formatFactor, formatMs, formatMsRange, formatNumber, listOf } from '../words/format';
import { competitorWord, isTechnique } from '../words/names';
import { type ThesisPair, timeIn } from './compareThesis';

/** Whether a run's figures bear a conclusion out. */
export type Verdict = 'Confirmed' | 'Confirmed in part' | 'Refuted' | 'Undecided';

/** A conclusion of the thesis, and what a run says to it. */
export interface Conclusion {
  /** What the thesis says, as a sentence. */
  readonly claim: string;
  readonly verdict: Verdict;
  /** The figures that decide, as sentences. */
  readonly evidence: string;
}

/** Frames a second below which the thesis no longer sees motion. */
const FLUENT = 15;

interface Both {
  readonly pair: ThesisPair;
  readonly forward: Spread;
  readonly deferred: Spread;
}

/**
 * The thesis's conclusions (its section 4.2.2 and chapter 5), each held against a run.
 *
 * @param pairs - rows of the thesis beside the run's
 * @param forward - the competitor that stands for the thesis's forward rendering
 */
export function conclusionsOf(run: LabRun, pairs: readonly ThesisPair[], forward = 'forward'): Conclusion[] {
  const both = pairs.flatMap((pair): Both[] => {
    const [a, b] = [timeIn(pair, forward), timeIn(pair, 'deferred')];
    return a && b ? [{ pair, forward: a, deferred: b }] : [];
  });
  const word = competitorWord(forward);
  const of = (test: (row: ThesisPair['thesis']) => boolean): Both[] => both.filter(({ pair }) => test(pair.thesis));
  return [
    {
      claim: 'With few lights over simple geometry forward is faster.',
      ...byRows(of(isSimple), -1, word),
    },
    {
      claim: 'With 100 lights or more over a plane forward falls behind deferred.',
      ...byRows(
        of(({ planes, lights }) => planes === 1 && lights >= 100),
        1,
        word,
      ),
    },
    {
      claim: 'With a mesh more complex than a plane forward loses already with 10 lights.',
      ...byRows(
        of(({ table, lights }) => table !== 'planes' && lights === 10),
        1,
        word,
      ),
    },
    { claim: 'Deferred falls more slowly than forward as lights are added.', ...byGrowth(both, word) },
    {
      claim: 'The G-buffer has a fixed cost: with little to light, deferred is the slower.',
      ...byBuffer(run, both, word),
    },
    { claim: 'With 500 lights deferred falls below 15 frames a second.', ...byFluency(pairs) },
    { claim: 'Deferred draws many lights fluently where forward cannot.', ...byReach(pairs, forward, word) },
  ];
}

/** The rows in which the thesis saw forward at 60 frames a second. */
function isSimple({ forward }: ThesisPair['thesis']): boolean {
  return forward !== null && forward[0] === 60;
}

const undecided = (evidence: string): Omit<Conclusion, 'claim'> => ({ verdict: 'Undecided', evidence });

/** Whether forward is faster (-1) or slower (1) than deferred in all of some rows. */
function byRows(rows: readonly Both[], expected: -1 | 1, word: string): Omit<Conclusion, 'claim'> {
  if (rows.length === 0) return undecided('The rows that would decide have no figures.');
  const orders = rows.map(({ forward, deferred }) => compareSpreads(forward, deferred));
  const yes = orders.filter((order) => order === expected).length;
  const no = orders.filter((order) => order === -expected).length;
  const figures = rows.map(({ pair, forward, deferred }, i) => {
    const tie = orders[i] === 0 ? ', a tie' : '';
    return `${pair.label}${sceneOf(pair)}: ${word} ${formatMs(forward.median)}, deferred ${formatMs(deferred.median)}${tie}`;
  });
  const evidence = `${figures.join('; ')}.`;
  if (yes === rows.length) return { verdict: 'Confirmed', evidence };
  if (no === rows.length) return { verdict: 'Refuted', evidence };
  if (yes === 0 && no === 0) return undecided(`${evidence} The spreads overlap.`);
  return { verdict: yes === 0 ? 'Refuted' : 'Confirmed in part', evidence };
}

function sceneOf({ thesis: { table } }: ThesisPair): string {
  return table === 'planes' ? '' : table === 'sponza' ? ' in the atrium' : ' in the temple';
}

/** How both times grow from the fewest to the most lights of each table. */
function byGrowth(both: readonly Both[], word: string): Omit<Conclusion, 'claim'> {
  const tables = [
    both.filter(({ pair: { thesis } }) => thesis.planes === 1),
    both.filter(({ pair: { thesis } }) => thesis.table === 'sponza'),
    both.filter(({ pair: { thesis } }) => thesis.table === 'temple'),
  ].filter((rows) => rows.length > 1);
  if (tables.length === 0) return undecided('No scene has figures of both with few and with many lights.');
  const growths = tables.map((rows) => {
    const [first, last] = [rows[0], rows.at(-1)!];
    const [a, b] = [growth(first.forward, last.forward), growth(first.deferred, last.deferred)];
    const order =
      a.low > b.high && a.middle > b.middle * (1 + SAME)
        ? 1
        : b.low > a.high && b.middle > a.middle * (1 + SAME)
          ? -1
          : 0;
    const where = first.pair.thesis.table === 'planes' ? 'over a plane' : sceneOf(first.pair).trim();
    const range = `${formatNumber(first.pair.thesis.lights)} to ${formatNumber(last.pair.thesis.lights)} lights`;
    const unsure = order === 0 ? ', which the spread makes unsure' : '';
    return {
      order,
      text: `${where}, from ${range}, ${word} takes ${formatFactor(a.middle)} as long, deferred ${formatFactor(b.middle)}${unsure}`,
    };
  });
  const text = `${growths.map((each) => each.text).join('; ')}.`;
  return decide(
    growths.map(({ order }) => order),
    text.charAt(0).toUpperCase() + text.slice(1),
  );
}

/** A verdict from signs: 1 for, -1 against, 0 unsure. */
function decide(orders: readonly number[], evidence: string): Omit<Conclusion, 'claim'> {
  const [yes, no] = [1, -1].map((sign) => orders.filter((order) => order === sign).length);
  if (yes === orders.length) return { verdict: 'Confirmed', evidence };
  if (yes > 0) return { verdict: 'Confirmed in part', evidence };
  return no > 0 ? { verdict: 'Refuted', evidence } : undecided(evidence);
}

/** How many times as long the second takes: of the medians, and at least and at most by the spreads. */
function growth(from: Spread, to: Spread): { low: number; middle: number; high: number } {
  const [a, b] = [boundsOf(from), boundsOf(to)];
  return { low: b.low / a.high, middle: to.median / from.median, high: b.high / a.low };
}

/** Deferred against forward with the least to light, and the G-buffer's time from few lights to many. */
function byBuffer(run: LabRun, both: readonly Both[], word: string): Omit<Conclusion, 'claim'> {
  const least = both.find(({ pair: { thesis } }) => thesis.planes === 1 && thesis.lights === 1);
  if (!least) return undecided('One plane under one light, which would decide, has no figures.');
  const order = compareSpreads(least.forward, least.deferred);
  const more = least.deferred.median - least.forward.median;
  const figures = `1 plane, 1 light: ${word} ${formatMs(least.forward.median)}, deferred ${formatMs(least.deferred.median)}`;
  const buffers = both.flatMap(({ pair }) => {
    if (pair.thesis.planes !== 1 || !pair.of) return [];
    const row = run.rows.find(
      ({ competitor, series, index }) =>
        competitor === 'deferred' && series === pair.of!.series.name && index === pair.of!.index,
    );
    const ms = row?.passes?.passes
      .filter(({ name }) => /g-?buffer/i.test(name))
      .reduce((sum, pass) => sum + pass.ms, 0);
    return ms !== undefined && ms > 0 ? [{ ms, lights: pair.thesis.lights }] : [];
  });
  const times = buffers.map(({ ms }) => ms);
  const isFixed = buffers.length < 2 || Math.max(...times) <= 1.25 * Math.min(...times);
  const range =
    buffers.length < 2
      ? ''
      : ` Its G-buffer takes ${formatMsRange(times)} from ${formatNumber(buffers[0].lights)} to ${formatNumber(buffers.at(-1)!.lights)} lights.`;
  if (order === 0) return undecided(`${figures}: the spreads overlap.${range}`);
  if (order === 1) return { verdict: 'Refuted', evidence: `${figures}.${range}` };
  return {
    verdict: isFixed ? 'Confirmed' : 'Confirmed in part',
    evidence: `${figures}, ${formatMs(more)} more.${range}`,
  };
}

/** Frames a second of deferred with 500 lights. */
function byFluency(pairs: readonly ThesisPair[]): Omit<Conclusion, 'claim'> {
  const rows = pairs.flatMap((pair) => {
    const time = pair.thesis.lights === 500 ? timeIn(pair, 'deferred') : undefined;
    return time ? [{ pair, rate: 1000 / time.median }] : [];
  });
  if (rows.length === 0) return undecided('Deferred has no figures with 500 lights.');
  const figures = rows.map(({ pair, rate }) => `${formatNumber(rate)} frames a second${sceneOf(pair)}`);
  return decide(
    rows.map(({ rate }) => (rate < FLUENT ? 1 : -1)),
    `${listOf(figures)}.`,
  );
}

/** Who draws more lights at 15 frames a second in each scene, and how far the best technique is. */
function byReach(pairs: readonly ThesisPair[], forward: string, word: string): Omit<Conclusion, 'claim'> {
  const scenes = (['sponza', 'temple'] as const).flatMap((table) => {
    const rows = pairs.filter(({ thesis }) => thesis.table === table);
    const [a, b] = [reachOf(rows, forward), reachOf(rows, 'deferred')];
    return a === null || b === null ? [] : [{ where: sceneOf(rows[0]).trim(), a, b }];
  });
  if (scenes.length === 0) return undecided('One of the two has no figures in the atrium or the temple.');
  const text = (lights: number): string =>
    lights === 0 ? 'with none of the counts measured' : `up to ${formatNumber(lights)} lights`;
  const figures = scenes.map(({ where, a, b }) => `${where}: deferred ${text(b)}, ${word} ${text(a)}`);
  const last = pairs.findLast(
    (pair) => pair.thesis.table !== 'planes' && timeIn(pair, 'deferred') && pair.entries.length > 1,
  );
  const best = last?.entries.find(({ competitor }) => isTechnique(competitor));
  const factor = last && best ? timeIn(last, 'deferred')!.median / best.time.median : 1;
  const since =
    best && best.competitor !== 'deferred' && factor > 1 + SAME
      ? ` ${capital(competitorWord(best.competitor))} draws ${last!.label}${sceneOf(last!)} ${formatFactor(factor)} as fast as deferred.`
      : '';
  return decide(
    scenes.map(({ a, b }) => (b > a ? 1 : b === 0 ? 0 : -1)),
    `15 frames a second ${figures.join('; ')}.${since}`,
  );
}

/** The most lights that a competitor draws at 15 frames a second in some rows, 0 for none; null where it has no figures. */
function reachOf(rows: readonly ThesisPair[], competitor: string): number | null {
  const measured = rows.flatMap((pair) => {
    const time = timeIn(pair, competitor);
    return time ? [{ lights: pair.thesis.lights, rate: 1000 / time.median }] : [];
  });
  if (measured.length === 0) return null;
  return Math.max(0, ...measured.filter(({ rate }) => rate >= FLUENT).map(({ lights }) => lights));
}
