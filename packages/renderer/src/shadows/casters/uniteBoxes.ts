/**
 * Finds the box round several boxes; all as centre and half sizes (m), 6 numbers each.
 * @param from - index of the first number of the first box in `boxes`
 * @param end - index after the last number of the last box
 * @param to - index of the first number in `out`
 */
export function uniteBoxes(boxes: Float64Array, from: number, end: number, out: Float64Array, to: number): void {
  for (let axis = 0; axis < 3; axis++) {
    let low = Infinity;
    let high = -Infinity;
    for (let i = from + axis; i < end; i += 6) {
      low = Math.min(low, boxes[i] - boxes[i + 3]);
      high = Math.max(high, boxes[i] + boxes[i + 3]);
    }
    out[to + axis] = 0.5 * (low + high);
    out[to + axis + 3] = 0.5 * (high - low);
  }
}
