/** Whether fingers are the device's first means of pointing. */
export const isTouchScreen = (): boolean => globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;
