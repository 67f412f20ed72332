/** Prefix of a scene in a URL's hash. */
export const PREFIX = '#scene=';

/** Whether a URL's hash contains a scene. */
export const isLink = (hash: string): boolean => hash.startsWith(PREFIX);
