/** Illuminances of the false colours (lx), a decade apart, and their sRGB colours. */
export const illuminanceStops: readonly (readonly [number, string])[] = [
  [0.1, '#1a1450'],
  [1, '#3050c8'],
  [10, '#1fa3c4'],
  [100, '#35b45c'],
  [1000, '#e8d534'],
  [10_000, '#ef7d1f'],
  [100_000, '#d81f3f'],
];
