/** What comes before the scene in an address. */
export const PREFIX = '#scene=';

/** Whether the part of an address after '#' holds a scene. */
export const isLink = (hash: string): boolean => hash.startsWith(PREFIX);
