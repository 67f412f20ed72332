/** Step of an arrow key: the declared step, 1 for integers, a hundredth of the range, or 0.1 without a range. */
export function stepOf(field: { step?: number; min?: number; max?: number; integer?: boolean }): number {
  if (field.step !== undefined) return field.step;
  if (field.integer) return 1;
  if (field.min === undefined || field.max === undefined) return 0.1;
  return 10 ** Math.round(Math.log10((field.max - field.min) / 100));
}
