/** Kinds of lamps whose electric power can stand for their light. */
export const lampKinds = ['incandescent', 'halogen', 'fluorescent', 'led'] as const;
/** One of `lampKinds`. */
export type LampKind = (typeof lampKinds)[number];

/**
 * Luminous efficacy of common lamps (lm/W): an A19 bulb of 60 W (870 lm), a quartz halogen lamp of 250 W (5,000 lm), a T8 tube
 * of 32 W (2,880 lm), and an LED lamp of 8 W in place of a bulb of 60 W.
 * @see IES Lighting Handbook, 9th edition, chapter 6, lamp data; US Department of Energy, Solid-State Lighting, for LEDs
 */
export const lampEfficacies: Readonly<Record<LampKind, number>> = {
  incandescent: 14.5,
  halogen: 20,
  fluorescent: 90,
  led: 100,
};
