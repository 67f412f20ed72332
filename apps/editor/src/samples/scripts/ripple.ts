/** A wave of height 1 and length 1: other scripts import it by './ripple'. */
export const ripple = (phase: number): number => 0.5 + 0.5 * Math.sin(phase * 2 * Math.PI);
