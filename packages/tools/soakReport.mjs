/**
 * @typedef {{ minutes: number, heap: number, objects: number }} Sample heap in kB, GPU objects, at a time since the beginning
 * @typedef {{ slope: number, error: number }} Slope a minute, with its standard error
 */

/** Share of the samples, the first ones, that are left out: programs, pools and late code are still being made then. */
const WARM_UP = 0.25;

/** Samples, once warm, from which a slope is believed. */
const ENOUGH = 12;

/** How many standard errors away from zero a slope must be to count. */
const CERTAIN = 4;

/** Growth over a whole run that is not called a leak (heap in kB, objects on the GPU). */
const noise = { heap: 1024, objects: 8 };

/**
 * The line of least squares through points.
 *
 * @param {readonly number[]} x
 * @param {readonly number[]} y
 * @returns {Slope} 0 ± Infinity for fewer than three points
 */
export function slopeOf(x, y) {
  const n = x.length;
  if (n < 3) return { slope: 0, error: Infinity };
  const meanX = x.reduce((sum, each) => sum + each, 0) / n;
  const meanY = y.reduce((sum, each) => sum + each, 0) / n;
  let xx = 0;
  let xy = 0;
  for (let i = 0; i < n; i++) {
    xx += (x[i] - meanX) ** 2;
    xy += (x[i] - meanX) * (y[i] - meanY);
  }
  if (xx === 0) return { slope: 0, error: Infinity };
  const slope = xy / xx;
  let rest = 0;
  for (let i = 0; i < n; i++) rest += (y[i] - meanY - slope * (x[i] - meanX)) ** 2;
  return { slope, error: Math.sqrt(rest / (n - 2) / xx) };
}

/**
 * How heap and GPU objects went, once warm, and whether they grow beyond noise.
 *
 * @param {readonly Sample[]} samples
 * @returns {{ heap: Slope, objects: Slope, grows: string[] }} a sentence for each that grows
 */
export function growthOf(samples) {
  const warm = samples.slice(Math.floor(samples.length * WARM_UP));
  const minutes = warm.map((sample) => sample.minutes);
  const heap = slopeOf(
    minutes,
    warm.map((sample) => sample.heap),
  );
  const objects = slopeOf(
    minutes,
    warm.map((sample) => sample.objects),
  );
  const span = warm.length > 1 ? minutes[minutes.length - 1] - minutes[0] : 0;
  /** @param {Slope} slope @param {number} most */
  const isGrowing = ({ slope, error }, most) => warm.length >= ENOUGH && slope > CERTAIN * error && slope * span > most;
  const grows = [];
  if (isGrowing(heap, noise.heap)) grows.push(`the heap grows by ${figure(heap)} kB a minute`);
  if (isGrowing(objects, noise.objects)) grows.push(`GPU objects grow by ${figure(objects)} a minute`);
  return { heap, objects, grows };
}

/** @param {Slope} slope */
export const figure = ({ slope, error }) => `${slope.toFixed(2)} ± ${error.toFixed(2)}`;
