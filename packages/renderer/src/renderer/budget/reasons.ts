/** Sentences of `BudgetInfo.reason` for a frame's scale. */
export const REASONS = {
  unknown: 'the time of a frame is not known yet',
  held: 'frames take the time of the budget at this scale',
  slow: 'frames took longer than the budget',
  fast: 'frames took less than the budget',
  smallest: 'frames take longer than the budget at the least scale',
  largest: 'frames take less than the budget at the largest scale',
  trial: 'a larger scale is tried',
};

/** Sentences of `BudgetInfo.reason` for frames drawn at full size. */
export const WHOLE = {
  buffered: "three's effects read its output buffer",
  several: 'the target has several textures',
  part: 'the target is part of a cube, an array or mipmaps',
  small: 'the picture is small',
};
