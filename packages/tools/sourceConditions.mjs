import { defaultClientConditions, defaultServerConditions } from 'vite';

/**
 * Condition of `exports` that leads to the sources of a package in this repository. Private: no tool of a host sets it,
 * and sources are not packed.
 */
export const sourceCondition = 'farol-source';

/** Conditions by which Vite takes the repository's packages from source: for pages. */
export const sourceConditions = [sourceCondition, ...defaultClientConditions];

/** Conditions by which Vite takes the repository's packages from source: for code in Node, such as unit tests. */
export const serverSourceConditions = [sourceCondition, ...defaultServerConditions];
