/**
 * Moves labels apart along one direction, in their order, as little as possible.
 *
 * @param wanted - places (pixels), any order
 * @param gap - least distance of two labels
 * @returns a place for each, in the order given; null where they do not all fit between `low` and `high`
 */
export function spreadLabels(wanted: readonly number[], gap: number, low: number, high: number): number[] | null {
  if ((wanted.length - 1) * gap > high - low) return null;
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b]);
  // blocks of labels that touch: each lies around the mean of what its labels want
  const blocks: { members: number[]; top: number }[] = [];
  const settle = (members: number[]): { members: number[]; top: number } => {
    const middle = members.reduce((sum, i, k) => sum + wanted[i] - k * gap, 0) / members.length;
    return { members, top: Math.max(low, Math.min(middle, high - (members.length - 1) * gap)) };
  };
  for (const i of order) {
    let block = settle([i]);
    for (let before = blocks.at(-1); before && before.top + before.members.length * gap > block.top;) {
      blocks.pop();
      block = settle([...before.members, ...block.members]);
      before = blocks.at(-1);
    }
    blocks.push(block);
  }
  const places = Array.from<number>({ length: wanted.length });
  for (const { members, top } of blocks) members.forEach((i, k) => (places[i] = top + k * gap));
  return places;
}
