/** Number of the sorting network's steps in one pass. */
const STEPS_PER_PASS = 3;

/**
 * The passes of a bitonic network over `2 ** bits` indices, three steps each, given as the bits in which the indices of two
 * partners differ; 0 for no step. The lower index of two partners receives the value that comes first.
 * @see Batcher 1968, Sorting Networks and Their Applications
 */
export function sortingNetwork(bits: number): (readonly [number, number, number])[] {
  const passes: [number, number, number][] = [];
  for (let stage = 1; stage <= bits; stage++) {
    // the first step of a stage mirrors its upper half, so that all comparators have one direction
    const steps = [2 ** stage - 1];
    for (let bit = stage - 2; bit >= 0; bit--) steps.push(2 ** bit);
    for (let i = 0; i < steps.length; i += STEPS_PER_PASS)
      passes.push([steps[i], steps[i + 1] ?? 0, steps[i + 2] ?? 0]);
  }
  return passes;
}
