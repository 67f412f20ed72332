export interface ChanceException {
  readonly seeds: readonly number[];
  readonly techniques: readonly string[];
  readonly reason: string;
}

/** Scenes by chance that techniques draw otherwise than stock three, and why. It may only become shorter. */
export const chanceExceptions: readonly ChanceException[] = [
  {
    seeds: [21],
    techniques: [
      ...['forward', 'forward-single-pass', 'tiled-forward', 'forward-plus', 'clustered-forward'],
      ...['deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass'],
    ],
    reason:
      'a spot light that throws a checker: 53 dB, 2.6% of pixels off, with the mipmaps of its map too; not yet understood',
  },
];
