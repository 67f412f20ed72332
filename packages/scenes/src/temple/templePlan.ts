/** Measures of the temple (m). It extends along z; its front is at +z. */
export const templePlan = {
  columnsAcross: 6,
  columnsAlong: 9,
  /** Distance between the axes of neighbouring columns. */
  spacing: 2.7,
  columnHeight: 6.2,
  columnRadius: 0.56,
  steps: 3,
  stepHeight: 0.32,
  stepDepth: 0.42,
  architraveHeight: 0.7,
  friezeHeight: 0.75,
  corniceHeight: 0.3,
  /** Overhang of the cornice (m). */
  cornice: 0.55,
  /** Slope of the roof: rise over half its width. */
  pitch: 0.27,
} as const;

const { columnsAcross, columnsAlong, spacing, steps, stepHeight } = templePlan;

/** Half the distance between the outer columns' axes, across and along, and the height of the floor (m). */
export const templeSize = {
  halfWidth: ((columnsAcross - 1) * spacing) / 2,
  halfLength: ((columnsAlong - 1) * spacing) / 2,
  floor: steps * stepHeight,
} as const;
