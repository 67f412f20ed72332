/** Kinds of lamps whose light can be given by electric power. */
export const lampKinds = ['incandescent', 'halogen', 'fluorescent', 'led'] as const;
/** Names of the kinds of lamps. */
export type LampKind = (typeof lampKinds)[number];

/**
 * Luminous efficacy of common lamps (lm/W): a bulb of 60 W (800 lm), a tungsten halogen lamp of 500 W at 230 V, a T8
 * tube of 32 W (2,800 lm at mid-life), and an LED lamp of 8 W (800 lm). Smaller bulbs and halogen lamps are less
 * efficient, larger ones more.
 * @see US Department of Energy, Lumens and the lightbulb: 450, 800 and 1,600 lm replace bulbs of 40, 60 and 100 W, LEDs
 *   of 8 to 12 W one of 60 W, https://www.energy.gov/energysaver/lumens-and-lightbulb and
 *   https://comaldarksky.org/?p=2080
 * @see Luminous efficacy, table "Lighting efficiency", https://en.wikipedia.org/wiki/Luminous_efficacy for halogen
 * @see Lighting Design Lab, Understanding high performance T8s,
 *   https://www.aircycle.com/articles/high-performance-t8s/: mean lumens of the 80 series
 */
export const lampEfficacies: Readonly<Record<LampKind, number>> = {
  incandescent: 800 / 60,
  halogen: 19.8,
  fluorescent: 87.5,
  led: 100,
};
