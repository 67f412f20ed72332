/** Steps of the sorting network in one pass. */
const STEPS_PER_PASS = 3;

/**
 * The passes of a bitonic network over `2 ** bits` places, three steps each: of each step the bits in which partners differ,
 * 0 for none. Of two partners the one with the lower place gets what comes first.
 * @see Batcher 1968, Sorting Networks and Their Applications
 */
export function sortingNetwork(bits: number): (readonly [number, number, number])[] {
  const passes: [number, number, number][] = [];
  for (let stage = 1; stage <= bits; stage++) {
    // the first step of a stage turns its upper half round, so that all comparators point one way
    const steps = [2 ** stage - 1];
    for (let bit = stage - 2; bit >= 0; bit--) steps.push(2 ** bit);
    for (let i = 0; i < steps.length; i += STEPS_PER_PASS)
      passes.push([steps[i], steps[i + 1] ?? 0, steps[i + 2] ?? 0]);
  }
  return passes;
}
