/** Measures of the atrium (m). It extends along x; its nave is open to the sky. */
export const atriumPlan = {
  length: 40,
  bays: 8,
  /** Half the width of the nave, to the columns' axes. */
  nave: 5,
  /** Half the whole width, to the outer walls. */
  outer: 10,
  /** Height of a storey. */
  storey: 6.2,
  /** Height at which the lower arches spring. */
  spring: 3.7,
  /** Height above the gallery at which the upper arches spring. */
  upperSpring: 3.5,
  /** Half the thickness of the arcades' walls. */
  thickness: 0.34,
  /** Thickness of the gallery's floor. */
  slab: 0.45,
} as const;

/** Width of a bay (m). */
export const bayWidth = atriumPlan.length / atriumPlan.bays;
