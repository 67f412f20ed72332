/**
 * @typedef {object} Stage
 * @property {readonly string[]} [needs] names of stages that must have passed before; those that are not asked for are ignored
 * @property {boolean} [alone] whether it uses all cores of a small machine; default false
 * @property {boolean} [waits] whether it waits for the network and hardly uses a core: it runs beside all others; default false
 * @property {() => Promise<boolean>} run true when all is well
 *
 * @typedef {'passed' | 'failed' | 'left out'} Outcome 'left out': a stage that it needs did not pass
 */

/**
 * Runs stages: side by side where they need not one another. A stage that fails ends none but those that need it.
 *
 * @param {Readonly<Record<string, Stage>>} stages - in the order that they are to start in
 * @param {object} options
 * @param {boolean} options.isSmall - whether the machine has few cores: a stage that is `alone` then waits for the others, and
 *   they for it, but for those that wait for the network
 * @param {(name: string) => void} [options.onStart]
 * @param {(name: string, outcome: Outcome) => void} [options.onEnd]
 * @returns {Promise<Record<string, Outcome>>} by name, in the order that they ended in
 * @throws {Error} when what a stage needs can never end, being in a circle
 */
export async function runStages(stages, { isSmall, onStart, onEnd }) {
  const waiting = new Set(Object.keys(stages));
  /** @type {Map<string, Promise<void>>} */
  const running = new Map();
  /** @type {Record<string, Outcome>} */
  const outcomes = {};
  /** @param {string} name @param {Outcome} outcome */
  const end = (name, outcome) => {
    outcomes[name] = outcome;
    running.delete(name);
    onEnd?.(name, outcome);
  };
  /** @param {string} name */
  const needsOf = (name) => (stages[name].needs ?? []).filter((need) => need in stages);
  /** @param {string} name */
  const hasRoom = (name) => {
    const busy = [...running.keys()].filter((other) => !stages[other].waits);
    if (!isSmall || stages[name].waits || busy.length === 0) return true;
    return !stages[name].alone && !busy.some((other) => stages[other].alone);
  };

  while (waiting.size > 0 || running.size > 0) {
    for (const name of waiting) {
      const needs = needsOf(name);
      if (needs.some((need) => outcomes[need] && outcomes[need] !== 'passed')) {
        waiting.delete(name);
        end(name, 'left out');
      } else if (needs.every((need) => outcomes[need] === 'passed') && hasRoom(name)) {
        waiting.delete(name);
        onStart?.(name);
        const run = stages[name].run().catch((error) => {
          console.error(error instanceof Error ? error.message : error);
          return false;
        });
        running.set(
          name,
          run.then((isWell) => end(name, isWell ? 'passed' : 'failed')),
        );
      }
    }
    if (running.size > 0) await Promise.race(running.values());
    else if (waiting.size > 0) throw new Error(`These stages wait for one another: ${[...waiting].join(', ')}.`);
  }
  return outcomes;
}
