/** Height of the tabs of a group (CSS pixels): as a finger where one is used. */
export const TAB_HEIGHT = matchMedia('(pointer: coarse)').matches ? 40 : 30;
