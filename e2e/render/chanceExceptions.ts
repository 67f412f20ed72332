export interface ChanceException {
  readonly seeds: readonly number[];
  readonly techniques: readonly string[];
  readonly reason: string;
}

/** Scenes by chance that techniques draw otherwise than stock three, and why. It may only become shorter. */
export const chanceExceptions: readonly ChanceException[] = [];
