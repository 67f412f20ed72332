/** Height of a group's tabs (CSS pixels), larger for fingers. */
export const TAB_HEIGHT = matchMedia('(pointer: coarse)').matches ? 40 : 30;
