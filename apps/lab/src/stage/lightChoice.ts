/** Parameters that set a scene's number of lights: `lights`, or `m` for a square of m × m. */
export function lightParameters(known: readonly string[], lights: number): Record<string, number> {
  if (known.includes('lights')) return { lights };
  return known.includes('m') ? { m: Math.ceil(Math.sqrt(lights)) } : {};
}

/** Indices of `count` out of `all` items, spread evenly; all indices if `count` is not less. */
export function evenly(count: number, all: number): number[] {
  if (count >= all) return Array.from({ length: all }, (_, i) => i);
  return Array.from({ length: count }, (_, i) => Math.floor((i * all) / count));
}
