/**
 * Moves labels apart along one direction, keeping their order, as little as possible.
 *
 * @param ideal - preferred places (pixels), in any order, which may overlap
 * @param gap - smallest distance between labels
 * @returns a place for each, in the order given; null if they do not all fit between `low` and `high`
 */
export function spreadLabels(ideal: readonly number[], gap: number, low: number, high: number): number[] | null {
  if ((ideal.length - 1) * gap > high - low) return null;
  const order = ideal.map((_, i) => i).sort((a, b) => ideal[a] - ideal[b]);
  // blocks of touching labels: each lies around the mean of its labels' ideal places
  const blocks: { members: number[]; top: number }[] = [];
  const settle = (members: number[]): { members: number[]; top: number } => {
    const middle = members.reduce((sum, i, k) => sum + ideal[i] - k * gap, 0) / members.length;
    return { members, top: Math.max(low, Math.min(middle, high - (members.length - 1) * gap)) };
  };
  for (const i of order) {
    let block = settle([i]);
    for (let previous = blocks.at(-1); previous && previous.top + previous.members.length * gap > block.top;) {
      blocks.pop();
      block = settle([...previous.members, ...block.members]);
      previous = blocks.at(-1);
    }
    blocks.push(block);
  }
  const places = Array.from<number>({ length: ideal.length });
  for (const { members, top } of blocks) members.forEach((i, k) => (places[i] = top + k * gap));
  return places;
}
