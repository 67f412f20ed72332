/**
 * @typedef {import('./benchMeasure.mjs').Measurement} Measurement
 *
 * @typedef {{ median: number, p95: number }} Spread ms: median of the rounds' medians, 95th percentile of all frames
 * @typedef {{ ms: number | null, ratio: number | null, programs: number, lights: number }} Change a frame after lights
 *   came or went: its time, that over an ordinary frame of its round, and programs compiled
 *
 * @typedef {object} Summary of one case over its rounds
 * @property {Spread | null} gpu
 * @property {Spread | null} cpu
 * @property {Spread | null} frame one frame that is waited for
 * @property {Spread | null} batch one of many frames that are waited for together
 * @property {number | null} firstMs
 * @property {Change | null} added
 * @property {Change | null} removed
 * @property {number} lights that the renderer found
 * @property {number} visible of them
 * @property {number} draws
 * @property {number} triangles
 * @property {number} programs linked until an ordinary frame
 * @property {number} uploadBytes of a frame in which the lights move
 * @property {number} stillUploadBytes of a frame in which nothing moves
 * @property {number} targetBytes
 * @property {string} technique that drew, where one was picked
 */

/**
 * Quantile with linear interpolation between order statistics.
 *
 * @param {readonly number[]} values - at least one
 * @param {number} q - 0 to 1
 * @throws {RangeError} without values
 */
export function quantile(values, q) {
  if (values.length === 0) throw new RangeError('No values: a quantile needs at least one.');
  const sorted = [...values].sort((a, b) => a - b);
  const at = (sorted.length - 1) * q;
  const low = Math.floor(at);
  return sorted[low] + (sorted[Math.ceil(at)] - sorted[low]) * (at - low);
}

/** @param {readonly number[]} values */
export const median = (values) => quantile(values, 0.5);

/**
 * Median of the rounds' medians, so that one disturbed round does not count, and p95 of all frames, so that it shows.
 * Null when no round has any.
 *
 * @param {readonly (readonly number[] | null)[]} rounds
 * @returns {Spread | null}
 */
export function spread(rounds) {
  const there = rounds.filter((round) => round !== null && round.length > 0).map((round) => round ?? []);
  if (there.length === 0) return null;
  return { median: median(there.map(median)), p95: quantile(there.flat(), 0.95) };
}

/**
 * @param {readonly Measurement[]} rounds - at least one
 * @returns {Summary}
 */
export function summarise(rounds) {
  const each = (/** @type {(round: Measurement) => number} */ pick) => median(rounds.map(pick));
  const first = rounds.map(({ firstMs }) => firstMs).filter((ms) => ms !== null);
  return {
    gpu: spread(rounds.map(({ gpu }) => gpu)),
    cpu: spread(rounds.map(({ cpu }) => cpu)),
    frame: spread(rounds.map(({ frame }) => frame)),
    batch: spread(rounds.map(({ batch }) => batch)),
    firstMs: first.length > 0 ? median(first) : null,
    added: change(rounds, 'added'),
    removed: change(rounds, 'removed'),
    lights: each(({ lights }) => lights),
    visible: each(({ visible }) => visible),
    draws: each(({ draws }) => draws),
    triangles: each(({ triangles }) => triangles),
    programs: each(({ programs }) => programs),
    uploadBytes: each(({ uploadBytes }) => uploadBytes),
    stillUploadBytes: each(({ stillUploadBytes }) => stillUploadBytes),
    targetBytes: each(({ targetBytes }) => targetBytes),
    technique: rounds[rounds.length - 1].technique,
  };
}

/** @param {readonly Measurement[]} rounds @param {'added' | 'removed'} which @returns {Change | null} */
function change(rounds, which) {
  const there = rounds.flatMap((round) => {
    const changed = round[which];
    if (!changed) return [];
    const ordinary = round.frame && round.frame.length > 0 ? median(round.frame) : null;
    return [{ ...changed, ratio: changed.ms === null || ordinary === null ? null : changed.ms / ordinary }];
  });
  if (there.length === 0) return null;
  const middle = (/** @type {(number | null)[]} */ values) => {
    const known = values.filter((value) => value !== null);
    return known.length > 0 ? median(known) : null;
  };
  return {
    ms: middle(there.map(({ ms }) => ms)),
    ratio: middle(there.map(({ ratio }) => ratio)),
    // a round that compiles is one too many
    programs: Math.max(...there.map(({ programs }) => programs)),
    lights: there[0].lights,
  };
}
