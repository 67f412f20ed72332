/** Result of `workSeconds` on the reference machine (s): see {@link machineSlowness}. */
const REFERENCE = 0.17;

const ROUNDS = 3;

/** Fixed JSON (7 MB) like that of a scene: objects with components with fields. */
let text = '';

function sceneLikeText() {
  const values = Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`field${i}`, i / 7]));
  const components = Array.from({ length: 3 }, (_, i) => ({ type: `Component${i}`, values }));
  return JSON.stringify(Array.from({ length: 8000 }, (_, i) => ({ id: `object-${i}`, components })));
}

/** Makes objects of a component's JSON. @param {{ type: string, values: Record<string, number> }} component */
function partOf({ type, values }) {
  const matrix = Array.from({ length: 16 }, () => 0);
  return { type, matrix, values: { ...values }, byName: new Map(Object.entries(values)) };
}

/** A fixed piece of work: reading JSON and making objects of it. @returns {number} time that this process worked (s) */
export function workSeconds() {
  text ||= sceneLikeText();
  const before = process.cpuUsage();
  /** @type {{ id: string, components: { type: string, values: Record<string, number> }[] }[]} */
  const objects = JSON.parse(text);
  const made = new Map(objects.map(({ id, components }) => [id, components.map(partOf)]));
  if (made.size !== objects.length) throw new Error('The work was not done.');
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1e6;
}

/**
 * How many times as long as the reference machine (one Intel Xeon core of an H100 host, Node 20) this machine needs now
 * for the same work; 1 where it is as fast or faster. Limits of time in tests are multiplied by it: it tells a slow
 * machine, or one that is busy just now, from slow code. It uses none of Farol's code, and takes half a second.
 *
 * @param {() => number} [work] - does it once; returns the time that this took (s)
 * @returns {number}
 */
export function machineSlowness(work = workSeconds) {
  const times = Array.from({ length: ROUNDS }, work).sort((a, b) => a - b);
  return Math.max(1, times[ROUNDS >> 1] / REFERENCE);
}
