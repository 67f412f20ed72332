/** How a scene is told a number of lights: `lights`, or `m` of them along the sides of a square. */
export function lightParameters(known: readonly string[], lights: number): Record<string, number> {
  if (known.includes('lights')) return { lights };
  return known.includes('m') ? { m: Math.ceil(Math.sqrt(lights)) } : {};
}

/** Indices of `count` of `all` things, spread evenly; all of them where there are no more. */
export function evenly(count: number, all: number): number[] {
  if (count >= all) return Array.from({ length: all }, (_, i) => i);
  return Array.from({ length: count }, (_, i) => Math.floor((i * all) / count));
}
